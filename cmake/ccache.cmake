# A second build is quick where ccache is installed; nothing depends on it.
find_program(TUMBLE_CCACHE ccache)
if(TUMBLE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers are served too, but only if ccache is told that their macros may differ. tools/package.sh
  # compiles with LC_ALL=C, which changes the words of warnings alone.
  set(ccache_settings CCACHE_SLOPPINESS=pch_defines,time_macros,locale)
  # One folder's objects serve another one, such as build/release build/package: ccache gives the compiler paths that
  # start from the build folder, and what the compiler says with paths as they were.
  if(TUMBLE_NAMES_NO_FOLDER)
    list(APPEND ccache_settings CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_ABSSTDERR=1)
  endif()
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env ${ccache_settings} ${TUMBLE_CCACHE})
endif()
