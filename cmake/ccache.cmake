# A second build is quick where ccache is installed; nothing depends on it.
find_program(TUMBLE_CCACHE ccache)
if(TUMBLE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers are served too, but only if ccache is told that their macros may differ.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${TUMBLE_CCACHE})
endif()
