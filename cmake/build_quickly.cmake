# tumble_build_quickly(): this folder and those below it are compiled with little optimisation. For code that waits for
# files, people or the libraries: optimising it takes longer than running it, and half the time of compiling it goes.
macro(tumble_build_quickly)
  add_compile_options($<$<CONFIG:Release,RelWithDebInfo>:-O1> -Wno-maybe-uninitialized) # which guesses wrong without -O2
endmacro()
