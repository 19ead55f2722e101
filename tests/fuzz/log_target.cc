// A file as it is: what a flipped bit, a cut or somebody else's file does to the reader.
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_log.h"

extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) {
  const auto bytes = tumble::fuzz::as_bytes(data, size);
  tumble::fuzz::use_log(std::make_shared<std::vector<std::byte>>(bytes.begin(), bytes.end()));
  return 0;
}
