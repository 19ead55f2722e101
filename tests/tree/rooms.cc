#include "tests/tree/rooms.h"

#include <algorithm>
#include <initializer_list>

namespace tumble::test {
namespace {

using Folders = std::vector<std::string_view>;

Folders operator+(Folders left, const Folders& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

// The state and all that it is made of.
const Folders kModel = {"src/base", "src/math", "src/model"};
const Folders kSharing = {"src/sharing"};
const Folders kKernels = kModel + Folders{"src/kernels/lanes", "src/kernels/contacts"};
const Folders kWorld = kKernels + kSharing + Folders{"src/kernels", "src/world"};
const Folders kSim = kWorld + Folders{"src/step"};

std::vector<Room> simulation() {
  const Folders find = kWorld + Folders{"src/collide"};
  const Folders islands = find + Folders{"src/layered/find"};
  const Folders order = islands + Folders{"src/layered/islands"};
  const Folders batch = order + Folders{"src/layered/order"};
  const Folders solve = batch + Folders{"src/layered/batch"};
  return {
      {"src/base", {}},
      {"src/sharing", {"src/base"}},
      {"src/math", {"src/base"}},
      {"src/model", {"src/base", "src/math"}},
      {"src/kernels/lanes", kModel},
      {"src/kernels/contacts", kModel + Folders{"src/kernels/lanes"}},
      {"src/kernels", kKernels},
      {"src/world", kKernels + kSharing + Folders{"src/kernels"}},
      {"src/collide", kWorld},
      {"src/thesis/ground", kWorld},
      {"src/thesis", find + Folders{"src/thesis/ground"}},
      {"src/layered/find", find},
      {"src/layered/islands", islands},
      {"src/layered/order", order},
      {"src/layered/batch", batch},
      {"src/layered/solve", solve},
      {"src/step", solve + Folders{"src/layered/solve", "src/thesis"}},
      {"src/threads", {"src/base"}},
      {"src/files", {"src/base"}},
      {"src/process", {"src/base"}},
      {"src/scenes", kModel},
  };
}

std::vector<Room> pictures() {
  const Folders scene = kModel + Folders{"src/render/gl", "src/render/picture"};
  return {
      {"src/render/gl", {"src/base"}},
      {"src/render/picture", {"src/base", "src/files", "src/render/gl"}},
      {"src/render/scene", scene},
      {"src/render/passes", scene + Folders{"src/render/scene"}},
      {"src/render", scene + Folders{"src/render/scene", "src/render/passes"}},
  };
}

std::vector<Room> logs() {
  const Folders codec = kSim + Folders{"schema", "replay/format"};
  const Folders log = codec + Folders{"replay/codec"};
  const Folders session = log + Folders{"replay/log"};
  const Folders above = session + Folders{"replay/session"};
  return {
      {"schema", {}},
      {"replay/format", kSim},
      {"replay/codec", codec},
      {"replay/log", log + Folders{"src/files"}},
      {"replay/session", session + Folders{"src/threads"}},
      {"replay/measure", above},
      {"replay/recover", above},
      {"replay/arrays", {"src/base"}},
      {"replay/import", session + Folders{"src/files"}},
      {"replay/import/csv", session + Folders{"replay/arrays", "replay/import"}},
      {"replay/recorder", {}},
      {"replay/stream", session + Folders{"replay/import"}},
      {"replay/picture", above + Folders{"src/render", "src/render/picture", "src/render/scene"}},
      {"replay/probe", above},
      {"replay/live", above + Folders{"src/threads", "src/render/scene", "replay/picture"}},
      {"replay/diff", above + Folders{"replay/measure", "replay/recover", "replay/picture"}},
      {"replay/view", above + Folders{"replay/measure"}},
      {"replay/blame", above + Folders{"replay/diff", "src/collide"}},
      {"replay/export/plan", above},
      {"replay/export/table", above + Folders{"src/files", "replay/arrays", "replay/export/plan"}},
      {"replay/export/scene",
       above + Folders{"src/files", "replay/export/plan", "src/render/scene", "src/render/picture"}},
      {"replay/export", {"src/base", "src/files", "replay/export/plan", "replay/export/table", "replay/export/scene"}},
  };
}

std::vector<Room> suite() {
  const Folders logs = kSim + Folders{"src/files",      "src/scenes",     "src/threads",    "schema",
                                      "replay/format",  "replay/codec",   "replay/log",     "replay/session",
                                      "replay/measure", "replay/recover", "replay/picture", "replay/diff"};
  const Folders parts = logs + Folders{"src/render", "src/render/picture", "golden/suite", "golden/expected"};
  const Folders engine = {"golden/suite",  "src/process",       "replay/arrays",
                          "replay/import", "replay/import/csv", "replay/stream"};
  const Folders run = parts + engine + Folders{"golden/judge"};
  const Folders above = run + Folders{"golden/engine", "golden/run"};
  return {
      {"golden/hunt/scene", kModel + Folders{"src/scenes"}},
      {"golden/hunt/judge", logs + Folders{"golden/hunt/scene"}},
      {"golden/hunt/apart", logs + Folders{"golden/hunt/judge"}},
      {"golden/suite", logs + Folders{"src/render/picture", "golden/hunt/judge"}},
      {"golden/expected", logs},
      {"golden/judge", parts + Folders{"replay/import"}},
      {"golden/engine", logs + engine},
      {"golden/hunt/engine", parts + Folders{"golden/engine", "src/process", "golden/hunt/scene", "golden/hunt/judge"}},
      {"golden/run", run + Folders{"golden/engine", "golden/hunt/scene", "golden/hunt/judge", "golden/hunt/engine"}},
      {"golden/canaries", above + Folders{"golden/hunt/scene", "golden/hunt/judge", "golden/hunt/apart",
                                          "src/render/scene", "src/render/gl", "src/render/passes"}},
      {"golden/report/page", {}},
      {"golden/bundle", above},
      {"golden/report", above + Folders{"golden/report/page", "golden/bundle"}},
      {"golden/bless", above},
      {"golden/hunt/shrink", logs + Folders{"golden/hunt/scene", "golden/hunt/judge"}},
      {"golden/hunt",
       parts + Folders{"src/process", "golden/engine", "golden/bundle", "golden/hunt/scene", "golden/hunt/judge",
                       "golden/hunt/apart", "golden/hunt/engine", "golden/hunt/shrink"}},
      {"golden", above + Folders{"golden/canaries", "golden/bundle", "golden/report", "golden/bless"}},
  };
}

std::vector<Room> program() {
  const Folders below = kSim + Folders{"src/scenes",
                                       "src/threads",
                                       "src/render",
                                       "src/render/picture",
                                       "replay/format",
                                       "replay/codec",
                                       "replay/log",
                                       "replay/session",
                                       "replay/measure",
                                       "replay/recover",
                                       "replay/arrays",
                                       "replay/import",
                                       "replay/import/csv",
                                       "replay/stream",
                                       "replay/picture",
                                       "replay/probe",
                                       "replay/diff",
                                       "replay/view",
                                       "replay/blame",
                                       "golden/suite",
                                       "golden/expected",
                                       "golden/judge",
                                       "golden/engine",
                                       "golden/run",
                                       "golden/canaries",
                                       "golden/report",
                                       "golden/bless",
                                       "golden/bundle",
                                       "golden",
                                       "src/files",
                                       "src/process",
                                       "golden/hunt/scene",
                                       "golden/hunt/judge",
                                       "golden/hunt/apart",
                                       "golden/hunt/shrink",
                                       "golden/hunt"};
  const Folders above = below + Folders{"tools/output", "tools/files", "tools/arguments"};
  return {
      {"tools/output", below + Folders{"replay/export/table"}},
      {"tools/files", below + Folders{"tools/output"}},
      {"tools/arguments", below + Folders{"tools/output", "tools/files"}},
      {"tools/manual", above},
      {"tools/bisect", above},
      {"tools/bench", above},
      {"tools/engine", above},
      {"tools/compare", above + Folders{"tools/engine"}},
      {"tools/hunt", above},
      {"tools/view", above + Folders{"golden/report/page", "tools/compare", "tools/bench"}},
      {"tools/commands", above + Folders{"replay/export/plan", "replay/export", "tools/bisect", "tools/bench",
                                         "tools/engine", "tools/compare", "tools/hunt", "tools/view"}},
      {"tools", above + Folders{"tools/manual", "tools/commands"}},
      {"tools/live", above + Folders{"src/render/gl", "src/render/scene", "replay/live", "tools"}},
  };
}

// The module for Python: beside the program, above the logs.
std::vector<Room> modules() {
  return {{"python/binding", kSim + Folders{"src/files", "src/threads", "src/scenes", "replay/format", "replay/log",
                                            "replay/session", "replay/import", "replay/view"}}};
}

// Nothing but tests includes tests, so their rows need no list.
std::vector<Room> tests() {
  std::vector<Room> rows;
  for (const char* folder : {"tests/support",
                             "tests/fuzz",
                             "tests/tree",
                             "tests/files",
                             "tests/process",
                             "tests/sim",
                             "tests/scenes",
                             "tests/render",
                             "tests/replay",
                             "tests/replay/measure",
                             "tests/recorder",
                             "tests/golden",
                             "tests/toy",
                             "tests/tools",
                             "tests/export",
                             "tests/outputs",
                             "tests/trial",
                             "tests/determinism",
                             "tests/install/consumer",
                             "bench",
                             "bench/peers"}) {
    rows.push_back({folder, {"*"}});
  }
  return rows;
}

std::vector<Room> all_rooms() {
  std::vector<Room> all;
  for (const std::vector<Room>& rows : {simulation(), pictures(), logs(), suite(), program(), modules(), tests()}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace

const std::vector<Room>& rooms() {
  static const std::vector<Room> kRooms = all_rooms();
  return kRooms;
}

std::string folder_of(const std::string& path) {
  const std::size_t end = path.find_last_of('/');
  return end == std::string::npos ? "" : path.substr(0, end);
}

const Room* room_of(const std::string& path) {
  const auto found = std::ranges::find(rooms(), folder_of(path), &Room::folder);
  return found == rooms().end() ? nullptr : &*found;
}

bool may_include(const Room& room, std::string_view folder) {
  if (folder == room.folder) return true;
  if (std::ranges::find(room.may_include, folder) != room.may_include.end()) return true;
  if (std::ranges::find(room.may_include, "*") == room.may_include.end()) return false;
  const auto wanted = std::ranges::find(rooms(), folder, &Room::folder);
  const auto own = std::ranges::find(rooms(), room.folder, &Room::folder);
  return wanted != rooms().end() && wanted < own;
}

}  // namespace tumble::test
