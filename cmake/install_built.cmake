# Declared before any other install rule, so that it runs first: `cmake --install` of what was not built ends before it
# leaves half a prefix.

# tumble_install_built(COMPONENT TARGETS...): the targets of a component; those that this build does not know are passed over.
function(tumble_install_built COMPONENT)
  set(files "")
  foreach(target IN LISTS ARGN)
    string(APPEND files "\"$<$<TARGET_EXISTS:${target}>:$<TARGET_FILE:${target}>>\" ")
  endforeach()
  install(CODE "
    foreach(file IN ITEMS ${files})
      if(file AND NOT EXISTS \"\${file}\")
        message(FATAL_ERROR \"found no \${file}, wanted all of the component ${COMPONENT} built; nothing was installed. \"
          \"Run cmake --build ${PROJECT_BINARY_DIR} first, or install a component that is built: \"
          \"cmake --install ${PROJECT_BINARY_DIR} --component program, live, development or python\")
      endif()
    endforeach()" COMPONENT ${COMPONENT})
endfunction()

tumble_install_built(program tumble)
tumble_install_built(live tumble-live)
tumble_install_built(development tumble_sim tumble_text tumble_threads tumble_scenes tumble_render tumble_files
  tumble_recorder tumble_probe tumble_replay tumble_schema tumble_golden tumble_process)
tumble_install_built(python tumble_python)
