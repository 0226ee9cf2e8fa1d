# Builds the viewer's page into viewer/built/, from where a source distribution takes it, so that who
# installs from it needs no Node. Without Node 20 the distribution is made without the page.
file(REMOVE_RECURSE ${PROJECT_SOURCE_DIR}/viewer/built)
include(cmake/viewer.cmake)
if(NOT VIEWER_PAGE)
  return()
endif()
if(NOT EXISTS ${VIEWER_PACKAGES})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env "PATH=${NODE_FOLDER}:$ENV{PATH}" ${NPM} ci --silent
    WORKING_DIRECTORY ${VIEWER} COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(
  COMMAND ${NODE} node_modules/vite/bin/vite.js build --logLevel warn --outDir ${VIEWER}/built
  WORKING_DIRECTORY ${VIEWER} COMMAND_ERROR_IS_FATAL ANY)
