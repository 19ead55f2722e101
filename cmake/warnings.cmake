# Warnings are errors, for our targets only.
add_library(tumble_warnings INTERFACE)
target_compile_options(tumble_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                                                 -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
# GCC 12 takes `":" + std::to_string(n)` for an overlapping copy (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # Text from a precompiled header is no longer known to be the library's, and then GCC 12 sees bounds broken there too.
  target_compile_options(tumble_warnings INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow
                                                     -Wno-stringop-overread)
endif()
