# Checks while the program runs: sanitizers, and SIM_DCHECK of src/base/check.h.
set(TUMBLE_SANITIZE "" CACHE STRING "Sanitizers for the whole build, as -fsanitize= takes them")
if(TUMBLE_SANITIZE)
  add_compile_options(-fsanitize=${TUMBLE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TUMBLE_SANITIZE})
  # What the sanitizers add makes GCC lose track of std::optional.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(tumble_warnings INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()

option(TUMBLE_DCHECKS "Check in this build what SIM_DCHECK says; builds without NDEBUG and with sanitizers always do" OFF)
if(TUMBLE_DCHECKS OR TUMBLE_SANITIZE)
  add_compile_definitions(TUMBLE_DCHECKS)
endif()
