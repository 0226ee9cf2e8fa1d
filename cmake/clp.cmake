# The solver of linear programs, COIN-OR CLP, behind one file of the library. Without it, or with
# ORTHOBALL_CLP=OFF, the library is built all the same, and says so when it is asked to enforce
# simplices.
if(NOT ORTHOBALL_CLP)
  return()
endif()

find_path(CLP_INCLUDE Clp_C_Interface.h PATH_SUFFIXES coin coin-or clp/coin)
find_library(CLP_LIBRARY Clp)
find_library(COINUTILS_LIBRARY CoinUtils)
mark_as_advanced(CLP_INCLUDE CLP_LIBRARY COINUTILS_LIBRARY)
if(NOT CLP_INCLUDE OR NOT CLP_LIBRARY OR NOT COINUTILS_LIBRARY)
  message(STATUS "COIN-OR CLP was not found: simplices cannot be enforced. ./bootstrap build gets it.")
  return()
endif()
set_source_files_properties(
  src/orthoball/weights/linear_program.cpp
  PROPERTIES COMPILE_DEFINITIONS ORTHOBALL_CLP COMPILE_OPTIONS "-isystem;${CLP_INCLUDE}")
# An installed library names them, to be found where its user has them.
target_link_libraries(
  orthoball PRIVATE "$<BUILD_INTERFACE:${CLP_LIBRARY};${COINUTILS_LIBRARY}>"
                    "$<INSTALL_INTERFACE:Clp;CoinUtils>")
