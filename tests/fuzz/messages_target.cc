// A log whose hashes are right whatever is in it: what lies behind them has to hold by itself.
#include "tests/fuzz/mend.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_log.h"

extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) {
  tumble::fuzz::use_log(
      std::make_shared<std::vector<std::byte>>(tumble::fuzz::mended(tumble::fuzz::as_bytes(data, size))));
  return 0;
}
