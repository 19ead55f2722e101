# Headers that nearly every file includes, parsed once for each kind of target. Files include what they use all the same:
# -DTUMBLE_PRECOMPILED=OFF builds without.
option(TUMBLE_PRECOMPILED "Precompile the standard library's headers and Eigen" ON)

# tumble_precompile(TARGET [HEADERS <gtest/gtest.h> ...]): the common headers and these.
# tumble_precompile(TARGET LIKE OTHER): the ones of another target that is compiled with the same flags.
function(tumble_precompile TARGET)
  cmake_parse_arguments(arg "" "LIKE" "HEADERS" ${ARGN})
  if(NOT TUMBLE_PRECOMPILED)
    return()
  endif()
  if(arg_LIKE)
    target_precompile_headers(${TARGET} REUSE_FROM ${arg_LIKE})
    return()
  endif()
  target_precompile_headers(${TARGET} PRIVATE
    <algorithm> <array> <charconv> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span> <string>
    <string_view> <utility> <variant> <vector> <Eigen/Core> ${arg_HEADERS})
endfunction()
