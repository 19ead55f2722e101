# What `cmake --install` installs, in components: `program` (tumble, its manual pages, completions, documents, scenes and
# golden cases), `live` (its window) and `development` (libraries, headers, CMake and pkg-config files). Libraries and manual pages are made at
# install time, so that a build for work on this tree does not wait for them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(install_work ${PROJECT_BINARY_DIR}/install)
set(install_data ${CMAKE_INSTALL_DATADIR}/tumble)
set(recorder_files replay/recorder/tumble_recorder.h replay/recorder/tumble_recorder.c replay/probe/tumble_probe.h
                   replay/probe/tumble_probe.c)

# The program, and what it finds relative to itself (tools/files/data_folder.h). `portable`: the same with the program for
# any Linux and the recorder's source, for the archive alone.
install(TARGETS tumble RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
if(TARGET tumble-live)
  install(TARGETS tumble-live RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT live)
endif()
if(TARGET tumble-portable)
  install(PROGRAMS $<TARGET_FILE:tumble-portable> DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME tumble
    COMPONENT portable EXCLUDE_FROM_ALL)
  install(FILES ${recorder_files} DESTINATION ${install_data}/recorder COMPONENT portable EXCLUDE_FROM_ALL)
endif()
# tumble_install_data(COMPONENT ...): data, documents, manual pages and completions.
function(tumble_install_data)
  install(DIRECTORY golden/cases DESTINATION ${install_data}/golden ${ARGN})
  install(FILES golden/tumble.toml DESTINATION ${install_data}/golden ${ARGN})
  install(DIRECTORY bench/scenes DESTINATION ${install_data}/bench ${ARGN})
  install(DIRECTORY schema/json schema/export DESTINATION ${install_data}/schema ${ARGN} FILES_MATCHING PATTERN *.schema.json
          PATTERN *.proto)
  install(FILES LICENSE CHANGES.md DESTINATION ${CMAKE_INSTALL_DOCDIR} ${ARGN})
  install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} ${ARGN})
  install(CODE "
    set(TUMBLE $<TARGET_FILE:tumble>)
    set(WORK ${install_work})
    set(CROSS \"${CMAKE_CROSSCOMPILING}\")
    include(${PROJECT_SOURCE_DIR}/cmake/install_manual.cmake)" ${ARGN})
  install(DIRECTORY ${install_work}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 ${ARGN})
  install(DIRECTORY ${install_work}/completion/ DESTINATION ${CMAKE_INSTALL_DATADIR} ${ARGN})
endfunction()
tumble_install_data(COMPONENT program)
tumble_install_data(COMPONENT portable EXCLUDE_FROM_ALL)

# Headers, under the names of cmake/public_headers.txt.
foreach(line IN LISTS public_header_lines)
  string(REGEX MATCH "^(tumble/[a-z0-9_/]+\\.h) +([a-z0-9_/]+\\.h)$" matched "${line}")
  get_filename_component(folder ${CMAKE_MATCH_1} DIRECTORY)
  install(FILES ${CMAKE_MATCH_2} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder} COMPONENT development)
endforeach()

# The recorder and the probes: C99, two files each, to copy into an engine's source or to link as Tumble::recorder. Their
# headers are spelled as when copied.
install(FILES replay/recorder/tumble_recorder.h replay/probe/tumble_probe.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tumble/recorder COMPONENT development)
install(FILES ${recorder_files} DESTINATION ${install_data}/recorder COMPONENT development)

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
tumble_install_library(recorder TARGETS tumble_recorder tumble_probe)
tumble_install_library(replay TARGETS tumble_replay tumble_schema)
tumble_install_library(golden TARGETS tumble_golden tumble_process tumble_schema)

# find_package(Tumble COMPONENTS ...), and pkg-config.
configure_package_config_file(cmake/install/TumbleConfig.cmake.in ${install_work}/TumbleConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR)
write_basic_package_version_file(${install_work}/TumbleConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${install_work}/TumbleConfig.cmake ${install_work}/TumbleConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Tumble COMPONENT development)
file(RELATIVE_PATH prefix_from_pkgconfig /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
foreach(part IN ITEMS sim render recorder replay golden)
  configure_file(cmake/install/tumble-${part}.pc.in ${install_work}/pkgconfig/tumble-${part}.pc @ONLY)
  install(FILES ${install_work}/pkgconfig/tumble-${part}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endforeach()
