# Builds that know nothing of the folder they are made in: two of one commit, in two folders, give the same bytes.
option(TUMBLE_KNOWS_SOURCE_FOLDER "The program finds scenes and cases in the folder it was built from" ON)
if(NOT TUMBLE_KNOWS_SOURCE_FOLDER)
  # The last one that fits counts, and a build folder may lie in the source folder.
  add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}=. -ffile-prefix-map=${PROJECT_BINARY_DIR}=build)
endif()
