# Everything comes from Debian packages; tools/setup.sh installs them.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
# CapnProtoConfig.cmake looks for libatomic with a program that only a C compiler takes; libcapnp links it by itself.
set(FOUND_LIBATOMIC TRUE)
find_package(CapnProto REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(pugixml REQUIRED)
if(TUMBLE_TESTS)
  find_package(GTest REQUIRED)
  find_package(benchmark REQUIRED)
endif()
find_package(Threads REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(TUMBLE_HTTPLIB IMPORTED_TARGET cpp-httplib) # optional: `tumble view` serves pages with it

# toml++ from its headers: the package's own target would link the shared library, and the bits of a scene would then
# depend on how somebody else compiled its number parser.
find_path(TUMBLE_TOML_INCLUDE toml++/toml.h REQUIRED)
add_library(tumble_toml INTERFACE)
add_library(tumble::toml ALIAS tumble_toml)
target_compile_definitions(tumble_toml INTERFACE TOML_HEADER_ONLY=1)
target_include_directories(tumble_toml SYSTEM INTERFACE ${TUMBLE_TOML_INCLUDE})

# tumble_library(NAME TARGET ARCHIVES...): tumble::NAME, a library of Debian's: TARGET, which is shared, or, in a program
# with the property TUMBLE_STATIC, these archives. So one build links the program of the Debian packages and the one for
# any Linux.
function(tumble_library NAME TARGET)
  set(archives "")
  foreach(archive IN LISTS ARGN)
    find_library(TUMBLE_ARCHIVE_${archive} NAMES lib${archive}.a)
    mark_as_advanced(TUMBLE_ARCHIVE_${archive})
    if(NOT TUMBLE_ARCHIVE_${archive})
      set(TUMBLE_LACKS_ARCHIVE lib${archive}.a PARENT_SCOPE)
    endif()
    string(APPEND archives "$<${in_static}:${TUMBLE_ARCHIVE_${archive}}>;")
  endforeach()
  add_library(tumble_library_${NAME} INTERFACE)
  add_library(tumble::${NAME} ALIAS tumble_library_${NAME})
  target_link_libraries(tumble_library_${NAME} INTERFACE $<$<NOT:${in_static}>:${TARGET}> ${archives})
  # Headers, also where the archives are linked.
  target_include_directories(tumble_library_${NAME} SYSTEM INTERFACE
    $<TARGET_PROPERTY:${TARGET},INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()
set(in_static $<BOOL:$<TARGET_PROPERTY:TUMBLE_STATIC>>)
tumble_library(capnp CapnProto::capnp capnp kj)
tumble_library(zstd PkgConfig::ZSTD zstd)
tumble_library(xxhash PkgConfig::XXHASH xxhash)
tumble_library(pugixml pugixml::pugixml pugixml)
tumble_library(png PNG::PNG png16 z)
tumble_library(zlib ZLIB::ZLIB z)

# Optional: `tumble export` writes MCAP files with it.
set(protobuf_MODULE_COMPATIBLE ON)
find_package(Protobuf 3 QUIET MODULE)
if(Protobuf_FOUND AND Protobuf_PROTOC_EXECUTABLE)
  tumble_library(protobuf protobuf::libprotobuf protobuf)
else()
  message(STATUS "No libprotobuf: tumble export writes no .mcap (install libprotobuf-dev and protobuf-compiler)")
endif()
