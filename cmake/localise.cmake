# cmake -DOUTPUT=lib.a -DARCHIVES=a.a;b.a -DLD=ld -DNM=nm -DOBJCOPY=objcopy -DAR=ar -P localise.cmake
#
# Makes one archive of several whose inline functions are their own. A program that is compiled with other flags (such
# as -march=native -ffp-contract=fast) brings its own copies of the inline functions in Eigen's and our headers, and a
# linker keeps one copy of each: the program's, with other bits. Here every symbol that is not a function or a variable of
# namespace tumble, defined once, is made local, so that the simulation calls the functions it was compiled with.
get_filename_component(name ${OUTPUT} NAME_WE)
get_filename_component(folder ${OUTPUT} DIRECTORY)
set(object ${folder}/${name}.o)
set(list ${folder}/${name}.local)
execute_process(COMMAND ${LD} -r --force-group-allocation -o ${object} --whole-archive ${ARCHIVES} --no-whole-archive
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${NM} --defined-only --format=posix ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n ]+ [A-Zuv] " defined "${symbols}")
set(local "")
foreach(symbol IN LISTS defined)
  string(REGEX MATCH "^([^ ]+) (.)" matched "${symbol}")
  set(name ${CMAKE_MATCH_1})
  set(kind ${CMAKE_MATCH_2})
  # Tables of virtual functions hold no arithmetic, and other archives name them. Data of inline functions (_ZZ) is strong.
  if(name MATCHES "^_ZT[VIS]N6tumble" OR (NOT kind MATCHES "[WVuv]" AND name MATCHES "^(_ZNK?6tumble|tumble_)"))
    continue()
  endif()
  list(APPEND local ${name})
endforeach()
list(JOIN local "\n" local)
file(WRITE ${list} "${local}\n")
execute_process(COMMAND ${OBJCOPY} --localize-symbols=${list} ${object} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${OUTPUT})
# D: no dates and no owners, so that two builds of one commit give one file.
execute_process(COMMAND ${AR} rcsD ${OUTPUT} ${object} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${object} ${list})
