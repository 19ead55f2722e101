# What `cpack` packs (tools/package.sh builds for it): Debian packages tumble, tumble-live, libtumble-dev and
# python3-tumble, and an archive of the program for any Linux. docs/packages.md describes them; package/finish.cmake adds
# the files that Debian's policy asks for. Dates are SOURCE_DATE_EPOCH's.
set(CPACK_PACKAGE_NAME tumble)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Tumble contributors <tumble@tumble.invalid>")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package/finish.cmake)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package/generator.cmake)
set(CPACK_GENERATOR DEB)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_TUMBLE_SOURCE ${PROJECT_SOURCE_DIR}) # for finish.cmake

# One .deb for each component of cmake/install.cmake.
set(CPACK_TUMBLE_COMPONENTS program development)
if(TARGET tumble-live)
  list(APPEND CPACK_TUMBLE_COMPONENTS live)
endif()
if(TARGET tumble_python)
  list(APPEND CPACK_TUMBLE_COMPONENTS python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(same_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# tumble_deb(COMPONENT NAME SECTION SUMMARY [DEPENDS ...] [RECOMMENDS ...] [SUGGESTS ...] TEXT ...)
function(tumble_deb COMPONENT NAME SECTION SUMMARY)
  cmake_parse_arguments(arg "" "" "DEPENDS;RECOMMENDS;SUGGESTS;TEXT" ${ARGN})
  string(TOUPPER ${COMPONENT} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${NAME} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
  foreach(kind IN ITEMS DEPENDS RECOMMENDS SUGGESTS)
    if(arg_${kind})
      list(JOIN arg_${kind} ", " names)
      set(CPACK_DEBIAN_${key}_PACKAGE_${kind} "${names}" PARENT_SCOPE)
    endif()
  endforeach()
  list(JOIN arg_TEXT "\n" text)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${SUMMARY}\n${text}" PARENT_SCOPE)
endfunction()

set(about "Tumble records sessions of physics engines with every input and every"
          "step's state, replays them bit for bit, names the first value that"
          "differs between two, and checks suites of accepted results in CI. It has"
          "a rigid-body engine of its own whose results repeat to the bit.")
tumble_deb(program tumble science "flight recorder and regression lab for physics engines"
  RECOMMENDS "libosmesa6 | libegl1" SUGGESTS tumble-live ffmpeg gnuplot-nox TEXT ${about})
tumble_deb(live tumble-live science "flight recorder for physics engines: window to play by hand"
  DEPENDS "tumble ${same_version}" TEXT ${about} "." "This package has the window of the command `tumble live`.")
tumble_deb(development libtumble-dev libdevel "flight recorder for physics engines: libraries and headers"
  DEPENDS libeigen3-dev libcapnp-dev libzstd-dev libxxhash-dev libpng-dev zlib1g-dev libpugixml-dev SUGGESTS tumble
  TEXT ${about} "." "This package has static libraries, headers, and files for CMake and"
       "pkg-config: simulation, logs, pictures, suites, and the recorder in C99 that"
       "engines link or copy.")
# The module of C++ is for one version of Python; the scripts compile the others and remove them.
get_property(python GLOBAL PROPERTY tumble_python_executable)
if(python)
  execute_process(COMMAND ${python} -c "import sys; a, b = sys.version_info[:2]; print(f'python3 (>= {a}.{b}), python3 (<< {a}.{b + 1})')"
                  OUTPUT_VARIABLE python_versions OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/package/python/postinst
                                              ${PROJECT_SOURCE_DIR}/cmake/package/python/prerm)
tumble_deb(python python3-tumble python "flight recorder for physics engines: Python module"
  DEPENDS "${python_versions}" python3-numpy "tumble ${same_version}" SUGGESTS python3-matplotlib
  TEXT ${about} "." "This package has the module `tumble` for Python 3.")

set(CPACK_TUMBLE_ARCHIVE tumble-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_PORTABLE_FILE_NAME ${CPACK_TUMBLE_ARCHIVE})
include(CPack)
