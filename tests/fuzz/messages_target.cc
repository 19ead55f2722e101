// A log whose hashes are right whatever is in it: what lies behind them has to hold by itself.
#include "tests/fuzz/mend.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/use_log.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tumble;
  fuzz::use_log(std::make_shared<std::vector<std::byte>>(fuzz::mended(fuzz::as_bytes(data, size))));
  return 0;
}
