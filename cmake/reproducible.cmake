# Objects that know nothing of the folder they are made in: two builds of one commit, in two folders, give the same bytes,
# and the compiler cache can give the preset `package` what `release` compiled (ccache.cmake). Debuggers and profilers
# want the folder: builds with debug information keep it, but for packages.
option(TUMBLE_KNOWS_SOURCE_FOLDER "The program finds scenes and cases in the folder it was built from" ON)
set(TUMBLE_NAMES_NO_FOLDER OFF)
if(NOT TUMBLE_KNOWS_SOURCE_FOLDER OR (CMAKE_BUILD_TYPE STREQUAL "Release" AND
                                      NOT "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" MATCHES "(^| )-g"))
  set(TUMBLE_NAMES_NO_FOLDER ON)
  # The last one that fits counts, and a build folder may lie in the source folder. ccache gives the compiler paths that
  # start from the build folder.
  file(RELATIVE_PATH from_build ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
  string(REGEX REPLACE "/$" "" from_build "${from_build}")
  if(from_build)
    add_compile_options(-ffile-prefix-map=${from_build}=.)
  endif()
  add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}=. -ffile-prefix-map=${PROJECT_BINARY_DIR}=build)
endif()
