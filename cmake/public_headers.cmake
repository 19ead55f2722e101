# Makes the public headers of public_headers.txt includable under the names that programs outside this tree use.
#
# In a build: include(public_headers) writes them to <build>/include.
# Without one: cmake -DOUT=FOLDER -P cmake/public_headers.cmake
#
# Each is a file of one #include and not a link, so that a compiler and clang-tidy name the file in the tree, debuggers
# find one file, and checkouts need no links.
if(CMAKE_SCRIPT_MODE_FILE)
  set(public_headers_at ${OUT})
else()
  set(public_headers_at ${PROJECT_BINARY_DIR}/include)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt)
  include_directories(${public_headers_at})
endif()

file(GLOB_RECURSE stale_headers ${public_headers_at}/tumble/*.h)
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt public_header_lines REGEX "^[^#]")
foreach(line IN LISTS public_header_lines)
  string(REGEX MATCH "^(tumble/[a-z0-9_/]+\\.h) +([a-z0-9_/]+\\.h)$" matched "${line}")
  if(NOT matched)
    message(FATAL_ERROR "cmake/public_headers.txt: not \"<spelling> <file>\": ${line}")
  endif()
  set(header ${public_headers_at}/${CMAKE_MATCH_1})
  set(text "#pragma once\n#include \"${CMAKE_MATCH_2}\"\n")
  list(REMOVE_ITEM stale_headers ${header})
  set(old "")
  if(EXISTS ${header})
    file(READ ${header} old)
  endif()
  if(NOT old STREQUAL text) # a new date would compile everything again
    file(WRITE ${header} "${text}")
  endif()
endforeach()
if(stale_headers)
  file(REMOVE ${stale_headers})
endif()
