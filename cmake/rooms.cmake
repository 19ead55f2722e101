# The files of a folder are compiled as one unit: headers, inline functions and templates are then paid for once a folder
# instead of once a file. -DTUMBLE_UNITY=OFF, and the preset `dev`, compile every file by itself: better for those who
# change one file again and again. Files must stand alone in either case; tools/lint.sh reads each by itself.
option(TUMBLE_UNITY "Compile the files of a folder as one unit" ON)

# tumble_room(TARGET a.cc b.cc ...): the files of this folder, as a part of TARGET. Files with flags of their own stay
# alone.
function(tumble_room TARGET)
  target_sources(${TARGET} PRIVATE ${ARGN})
  if(NOT TUMBLE_UNITY)
    return()
  endif()
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REPLACE "/" "_" room ${room})
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")
  set_source_files_properties(${ARGN} TARGET_DIRECTORY ${TARGET} PROPERTIES UNITY_GROUP ${room})
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
