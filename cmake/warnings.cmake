# One flag set for everything that is ours.
add_library(orthoball_warnings INTERFACE)
target_compile_options(
  orthoball_warnings
  INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion
            -Wundef -Werror
            # g++ 12 warns wrongly where a string is put behind a literal (its bug 105651).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
            # It also tells of a change in passing aligned types by value, of version 4.6.
            $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)
