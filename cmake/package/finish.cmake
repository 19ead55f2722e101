# Run by cpack on the installed files before they are packed. Gives each Debian package what Debian's policy asks for:
# copyright, both changelogs and manual pages compressed. Then one date for all files.
set(epoch $ENV{SOURCE_DATE_EPOCH})
if(NOT epoch)
  message(FATAL_ERROR "cpack: wanted SOURCE_DATE_EPOCH, the date of all files in seconds since 1970: run tools/package.sh")
endif()
set(root ${CPACK_TEMPORARY_DIRECTORY})

# Compresses a file without its name and date.
function(compress FILE)
  execute_process(COMMAND gzip -9nf ${FILE} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(finish_deb COMPONENT)
  string(TOUPPER ${COMPONENT} key)
  set(package ${CPACK_DEBIAN_${key}_PACKAGE_NAME})
  set(doc ${root}/${COMPONENT}/usr/share/doc/${package})
  file(MAKE_DIRECTORY ${doc})
  file(REMOVE ${doc}/LICENSE ${doc}/CHANGES.md)
  file(READ ${CPACK_TUMBLE_SOURCE}/LICENSE licence)
  string(REGEX MATCH "Copyright[^\n]*" holder "${licence}")
  string(REGEX REPLACE "^.*\n(Permission is hereby)" "\\1" licence "${licence}")
  string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
  string(REGEX REPLACE "\n$" "" licence "${licence}")
  string(REPLACE "\n" "\n " licence "${licence}")
  string(REPLACE "Copyright (c)" "" holder "${holder}")
  file(WRITE ${doc}/copyright
       "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: Tumble\n\n"
       "Files: *\nCopyright:${holder}\nLicense: Expat\n ${licence}\n")
  set(ENV{LC_ALL} C)
  execute_process(COMMAND date -u -R -d @${epoch} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${doc}/changelog.Debian
       "tumble (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
       "  * changelog.gz lists the changes of this version.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  file(COPY ${CPACK_TUMBLE_SOURCE}/CHANGES.md DESTINATION ${doc})
  file(RENAME ${doc}/CHANGES.md ${doc}/changelog)
  file(GLOB pages ${root}/${COMPONENT}/usr/share/man/man1/*.1)
  foreach(file IN LISTS pages ITEMS ${doc}/changelog ${doc}/changelog.Debian)
    compress(${file})
  endforeach()
  file(GLOB overrides ${CPACK_TUMBLE_SOURCE}/cmake/package/${package}.lintian-overrides)
  if(overrides)
    file(COPY_FILE ${overrides} ${root}/${COMPONENT}/${package})
    file(MAKE_DIRECTORY ${root}/${COMPONENT}/usr/share/lintian/overrides)
    file(RENAME ${root}/${COMPONENT}/${package} ${root}/${COMPONENT}/usr/share/lintian/overrides/${package})
  endif()
endfunction()

if(CPACK_GENERATOR STREQUAL "DEB")
  foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    finish_deb(${component})
  endforeach()
endif()
execute_process(COMMAND find ${root} -exec touch -h -d @${epoch} {} +  COMMAND_ERROR_IS_FATAL ANY)
