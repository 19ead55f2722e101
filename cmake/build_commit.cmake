# cmake -DSOURCE=FOLDER -DOUTPUT=FILE.o -DCOMPILER=c++ -DFLAGS="..." -DALL_FLAGS="..." -P build_commit.cmake
#
# Makes the object that tells a program the commit it is linked at, whether the sources were changed since, and the flags
# of its build (FLAGS compiles the object). Run before
# each link of the program: a new commit compiles nothing else anew, and a build that links nothing asks git nothing.
set(commit "")
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --verify HEAD
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed OR NOT commit MATCHES "^[0-9a-f]+$")
    set(commit "")
  else()
    execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET RESULT_VARIABLE failed)
    if(NOT failed AND changes STREQUAL "")
      string(APPEND commit " clean")
    elseif(NOT failed)
      string(APPEND commit " changed")
    endif()
  endif()
endif()
string(REPLACE "\\" "/" ALL_FLAGS "${ALL_FLAGS}")
string(REPLACE "\"" "'" ALL_FLAGS "${ALL_FLAGS}")
file(WRITE ${OUTPUT}.cc "extern \"C\" const char* tumble_build_commit() { return \"${commit}\"; }\n"
                        "extern \"C\" const char* tumble_build_flags() { return \"${ALL_FLAGS}\"; }\n")
separate_arguments(FLAGS UNIX_COMMAND "${FLAGS}")
execute_process(COMMAND ${COMPILER} ${FLAGS} -c ${OUTPUT}.cc -o ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
