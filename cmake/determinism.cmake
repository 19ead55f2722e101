# What keeps every bit of a step the same on every compiler, flag and machine (docs/determinism.md). For the whole
# build: one file without them would be enough to break the promise through an inline function.
add_compile_options(-ffp-contract=off)
add_compile_definitions(EIGEN_DONT_VECTORIZE EIGEN_FAST_MATH=0)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC's vectorisers fuse multiplications and additions in spite of -ffp-contract=off.
  add_compile_options(-fno-tree-vectorize)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^i[3-6]86$")
  # x87 registers keep 80 bits.
  add_compile_options(-msse2 -mfpmath=sse)
endif()
