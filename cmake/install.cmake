# What `cmake --install` installs, in two components: `program` (tumble, its manual pages, completions, scenes and golden
# cases) and `development` (libraries, headers, CMake and pkg-config files). Libraries and manual pages are made at
# install time, so that a build for work on this tree does not wait for them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(install_work ${PROJECT_BINARY_DIR}/install)
set(install_data ${CMAKE_INSTALL_DATADIR}/tumble)

# The program, and what it finds relative to itself (tools/files/data_folder.h).
install(TARGETS tumble RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
if(TARGET tumble-live)
  install(TARGETS tumble-live RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
install(DIRECTORY golden/cases DESTINATION ${install_data}/golden COMPONENT program)
install(DIRECTORY bench/scenes DESTINATION ${install_data}/bench COMPONENT program)
install(FILES LICENSE CHANGES.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(CODE "
  set(TUMBLE $<TARGET_FILE:tumble>)
  set(WORK ${install_work})
  set(CROSS \"${CMAKE_CROSSCOMPILING}\")
  include(${CMAKE_CURRENT_LIST_DIR}/install_manual.cmake)" COMPONENT program)
install(DIRECTORY ${install_work}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(DIRECTORY ${install_work}/completion/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT program)

# Headers, under the names of cmake/public_headers.txt.
foreach(line IN LISTS public_header_lines)
  string(REGEX MATCH "^(tumble/[a-z0-9_/]+\\.h) +([a-z0-9_/]+\\.h)$" matched "${line}")
  get_filename_component(folder ${CMAKE_MATCH_1} DIRECTORY)
  install(FILES ${CMAKE_MATCH_2} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder} COMPONENT development)
endforeach()

# The recorder and the probes: C99, two files each, to copy into an engine's source.
install(FILES replay/recorder/tumble_recorder.h replay/recorder/tumble_recorder.c replay/probe/tumble_probe.h
              replay/probe/tumble_probe.c
  DESTINATION ${install_data}/recorder COMPONENT development)

# tumble_install_library(NAME TARGETS a b ...): one archive, lib/libtumble_NAME.a, of these static libraries.
function(tumble_install_library NAME)
  cmake_parse_arguments(arg "" "" "TARGETS" ${ARGN})
  set(archives "")
  foreach(target IN LISTS arg_TARGETS)
    list(APPEND archives $<TARGET_FILE:${target}>)
  endforeach()
  set(output ${install_work}/lib/libtumble_${NAME}.a)
  install(CODE "
    file(MAKE_DIRECTORY ${install_work}/lib)
    execute_process(COMMAND \"${CMAKE_COMMAND}\" -DOUTPUT=${output} \"-DARCHIVES=${archives}\" -DLD=${CMAKE_LINKER}
      -DNM=${CMAKE_NM} -DOBJCOPY=${CMAKE_OBJCOPY} -DAR=${CMAKE_AR} -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/localise.cmake
      COMMAND_ERROR_IS_FATAL ANY)" COMPONENT development)
  install(FILES ${output} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endfunction()

tumble_install_library(sim TARGETS tumble_sim tumble_text tumble_threads tumble_scenes)
tumble_install_library(render TARGETS tumble_render tumble_files)
tumble_install_library(replay TARGETS tumble_replay tumble_probe tumble_schema)

# find_package(Tumble COMPONENTS ...), and pkg-config.
configure_package_config_file(cmake/install/TumbleConfig.cmake.in ${install_work}/TumbleConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR)
write_basic_package_version_file(${install_work}/TumbleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${install_work}/TumbleConfig.cmake ${install_work}/TumbleConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble COMPONENT development)
file(RELATIVE_PATH prefix_from_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
foreach(part IN ITEMS sim render replay)
  configure_file(cmake/install/tumble-${part}.pc.in ${install_work}/pkgconfig/tumble-${part}.pc @ONLY)
  install(FILES ${install_work}/pkgconfig/tumble-${part}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endforeach()
