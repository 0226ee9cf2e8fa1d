# The solver of linear programs, COIN-OR CLP, behind one file of the library. Without it, or with
# ORTHOBALL_CLP=OFF, the library is built all the same, and says so when it is asked to enforce
# simplices.
if(NOT ORTHOBALL_CLP)
  return()
endif()

find_path(CLP_INCLUDE Clp_C_Interface.h PATH_SUFFIXES coin coin-or clp/coin)
find_library(CLP_LIBRARY Clp)
mark_as_advanced(CLP_INCLUDE CLP_LIBRARY)
if(NOT CLP_INCLUDE OR NOT CLP_LIBRARY)
  message(STATUS "COIN-OR CLP was not found: simplices cannot be enforced. ./bootstrap build gets it.")
  return()
endif()
get_filename_component(CLP_FILE ${CLP_LIBRARY} REALPATH)
get_filename_component(CLP_FILE ${CLP_FILE} NAME)
string(REGEX REPLACE "(\\.so\\.[0-9]+).*" "\\1" CLP_FILE ${CLP_FILE})
set_source_files_properties(
  src/orthoball/weights/linear_program.cpp
  PROPERTIES COMPILE_DEFINITIONS "ORTHOBALL_CLP=\"${CLP_FILE}\"" COMPILE_OPTIONS
                                                                 "-isystem;${CLP_INCLUDE}")
# It is loaded when it is needed.
target_link_libraries(orthoball PRIVATE ${CMAKE_DL_LIBS})
