// import as the program runs it: any text as another engine's table.
#include "tests/fuzz/program_place.h"
#include "tests/fuzz/target.h"

extern "C" int test_one_input(const std::uint8_t* data, std::size_t size) {
  using tumble::tools::Exit;
  static const tumble::fuzz::ProgramPlace place;
  const std::string table = place.path("input.csv");
  const std::string log = place.path("output.tumble");
  place.write("input.csv", tumble::fuzz::as_bytes(data, size));
  place.remove("output.tumble");
  const tumble::fuzz::Outcome import = place.run({"import", table, "-o", log});
  require_exit(import, {Exit::kSame, Exit::kBadInput}, table);
  require(place.has("output.tumble") == (import.exit == Exit::kSame), "wanted a log, or an error and none", import);
  if (import.exit != Exit::kSame) return 0;
  const tumble::fuzz::Outcome info = place.run({"info", log});
  require(info.exit == Exit::kSame, "wanted an imported log to be whole", info);
  const tumble::fuzz::Outcome replay = place.run({"replay", log});
  require(replay.exit == Exit::kBadInput, "wanted another engine's log not to be replayed", replay);
  return 0;
}
