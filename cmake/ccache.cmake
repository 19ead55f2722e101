# A second build is quick where ccache is installed; nothing depends on it.
find_program(TUMBLE_CCACHE ccache)
if(TUMBLE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${TUMBLE_CCACHE})
endif()
