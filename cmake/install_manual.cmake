# include() with TUMBLE, WORK and CROSS: the manual pages and completions, printed by the program TUMBLE itself from the
# arguments that its commands declare, into WORK/man and WORK/completion. A cross build has no program to run.
file(REMOVE_RECURSE ${WORK}/man ${WORK}/completion)
file(MAKE_DIRECTORY ${WORK}/man ${WORK}/completion)
if(CROSS)
  message(STATUS "Manual pages and completions are left out: this program runs on another machine")
  return()
endif()

# tumble_print(FILE ARGUMENTS...): what the program prints, into a file.
function(tumble_print FILE)
  get_filename_component(folder ${FILE} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${TUMBLE} ${ARGN} OUTPUT_FILE ${FILE} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

tumble_print(${WORK}/man/tumble.1 help --man)
file(STRINGS ${WORK}/man/tumble.1 lines REGEX "^\\\\fBtumble\\\\-[a-z]+\\\\fR\\(1\\)$")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^.*tumble\\\\-([a-z]+).*$" "\\1" command "${line}")
  tumble_print(${WORK}/man/tumble-${command}.1 help --man ${command})
endforeach()
tumble_print(${WORK}/completion/bash-completion/completions/tumble help --completion bash)
tumble_print(${WORK}/completion/zsh/vendor-completions/_tumble help --completion zsh)
tumble_print(${WORK}/completion/fish/vendor_completions.d/tumble.fish help --completion fish)
