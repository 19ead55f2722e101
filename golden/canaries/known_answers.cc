#include "golden/canaries/known_answers.h"

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/parse_hash.h"
#include "src/base/text.h"
#include "src/base/utf8.h"
#include "src/files/output_file.h"
#include "src/files/output_guard.h"
#include "src/process/split_words.h"
#include "src/render/scene/pick.h"
#include "src/render/scene/view.h"
#include "tumble/process/job_pool.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;
using sim::Vec3;

constexpr std::uint32_t kCodesEnd = 0x110000;

// The longest ranges of characters for which `holds` does: "0-8 b-1f 7f".
std::string ranges(const std::function<bool(std::uint32_t code)>& holds) {
  std::string text;
  const auto hex = [](std::uint32_t code) {
    std::string digits;
    for (; code > 0 || digits.empty(); code /= 16) digits.insert(digits.begin(), "0123456789abcdef"[code % 16]);
    return digits;
  };
  for (std::uint32_t code = 0; code < kCodesEnd; ++code) {
    if (!holds(code)) continue;
    const std::uint32_t first = code;
    while (code + 1 < kCodesEnd && holds(code + 1)) ++code;
    text += (text.empty() ? "" : " ") + hex(first) + (code > first ? "-" + hex(code) : "");
  }
  return text;
}

std::string utf8_of(std::uint32_t code) {
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  const auto rest = [&](unsigned shift) { return std::string(1, byte(0x80U | (code >> shift & 0x3FU))); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return byte(0xC0U | code >> 6U) + rest(0);
  if (code < 0x10000) return byte(0xE0U | code >> 12U) + rest(6) + rest(0);
  return byte(0xF0U | code >> 18U) + rest(12) + rest(6) + rest(0);
}

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::string numbers_read() {
  std::string found;
  for (const char* text :
       {"0.1", "-2e-3", "nan(0x7ff8000000000000)", "inf(0x7ff0000000000000)", "nan(0x7ff0000000000000)", "nan(0x1)",
        "nan(0x7ff8000000000000", "nan(ind)", "1)", "", "1x", "inf", "-0"}) {
    const std::optional<double> number = parse_exact(text);
    found += (number ? exact_bits(*number) : "none") + " ";
  }
  return found;
}

std::string hashes_read() {
  std::string found;
  for (const char* text : {"0123456789abcdef00112233445566ff", "0123456789abcdef00112233445566f", "",
                           "0123456789abcdeg00112233445566ff", "0123456789abcdef00112233445566f "}) {
    const std::optional<Hash128> hash = parse_hash(text);
    found += (hash ? to_string(*hash) : "none") + " ";
  }
  return found;
}

std::string command_words(const std::string& command) {
  const Result<std::vector<std::string>> words = process::split_words(command);
  if (!words.ok()) return words.error().message;
  std::string found;
  for (const std::string& word : *words) found += word + "|";
  return found;
}

std::string ranges_hidden() {
  return ranges([](std::uint32_t code) { return !is_shown_as_read(code); });
}

std::string ranges_read() {
  return ranges([](std::uint32_t code) {
    const std::string text = "a" + utf8_of(code);
    const Character c = utf8_at(text, 1);
    return c.code == code && c.length == text.size() - 1;
  });
}

void texts(CanaryRoll& roll) {
  roll.known("characters that do not show as they are read are replaced", ranges_hidden,
             "0-8 b-1f 7f-9f 200e-200f 202a-202e 2066-2069 fffe-ffff");
  roll.known("every character is read, and no surrogate", ranges_read, "0-d7ff e000-10ffff");
  roll.known(
      "bytes that are no character are replaced",
      [] { return printable("\xC0\x80 \xE0\x80\x80 \xF4\x90\x80\x80 \xE2\x82"); }, "?? ??? ???? ??");
  roll.known(
      "a text is as wide as its characters", [] { return std::to_string(columns("1 µm → 2 m")); }, "10");
  roll.known(
      "numbers are written shortest",
      [] {
        return exact(0.1) + " " + exact(-0.0) + " " + exact(1e-7) + " " + number_text(1e-5) + " " + exact(1.0 / 3);
      },
      "0.1 -0 1e-07 0.00001 0.3333333333333333");
  roll.known(
      "numbers that are none keep their bits",
      [] { return exact_bits(kNoNumber) + " " + exact_bits(-kInfinite) + " " + numbers_read(); },
      "nan(0x7ff8000000000000) -inf(0xfff0000000000000) 0.1 -0.002 nan(0x7ff8000000000000) inf(0x7ff0000000000000) "
      "none none none nan(0x7ff8000000000000) none none none inf(0x7ff0000000000000) -0 ");
  roll.known(
      "text of other programs becomes valid",
      [] { return valid_text("a\xC0z\xE2\x82\xAC\xFF") + padded_left("µm", 4); }, "a�z€�  µm");
  roll.known("hashes are read as they are written", hashes_read,
             "0123456789abcdef00112233445566ff none none none none ");
  roll.known(
      "values have their units",
      [] {
        return rounded(1.23456e-7, "m") + ", " + bytes_text(4'210'000) + ", " + seconds_text(0.012) + ", " +
               count_text(1, "body") + ", " + count_text(3, "body");
      },
      "1.235e-07 m, 4.2 MB, 12.0 ms, 1 body, 3 bodies");
  roll.known(
      "a command is split into words",
      [] {
        return command_words("a 'b c'  \"d \\\" e\"\tf\\ g '' h'i'j '\\'") + "; " + command_words("a 'b") + "; " +
               command_words(" ");
      },
      "a|b c|d \" e|f g||hij|\\|; found a quote without its end in: a 'b; found no word in the command");
  roll.known(
      "a slip of a word is guessed",
      [] {
        return std::string(nearest_word("frictoin", {"mass", "friction", "fraction"}));
      },
      "friction");
}

// A service may run without standard input: the first file that is opened then has the number 0.
CanaryResult written_without_input() {
  CanaryResult result{"", false, "it was not"};
  const TemporaryFolder scratch("tumble-canary");
  process::run_jobs(
      1,
      [&scratch](std::size_t) {
        ::close(STDIN_FILENO);
        const Status ok = files::write_whole_file((scratch.path() / "file").string(), "x");
        return ok.ok() ? std::string("written") : ok.error().message;
      },
      [&result](std::size_t, const process::JobResult& child) {
        result.caught = child.output == "written";
        result.message = child.failure.empty() ? child.output : child.failure;
      },
      {});
  return result;
}

// What a guard says of an output at a place in a folder with a case, a log that is read and a file of nobody's.
std::string guarded(const fs::path& folder, const std::string& place) {
  files::OutputGuard guard;
  guard.keep(folder / "read.tumble", "the log that is read");
  guard.keep_folder(folder / "kept", "the report");
  if (const Status first = guard.claim("--plot", folder / "plot.svg"); !first.ok()) return first.error().message;
  const Status ok = guard.claim("-o", folder / place);
  return ok.ok() ? "written" : "refused";
}

std::string outputs() {
  const TemporaryFolder scratch("tumble-canary");
  const fs::path& folder = scratch.path();
  std::error_code error;
  if (folder.empty() || !fs::create_directories(folder / "case", error) ||
      !fs::create_directories(folder / "kept/in", error))
    return "no temporary folder could be made";
  for (const char* name : {"case/scene.toml", "case/metrics.toml", "case/expected.tumble", "case/frame_0001.png",
                           "case/notes.txt", "read.tumble", "other.tumble", "kept/in/one.txt", "scene.toml"}) {
    if (const Status ok = write_file(folder / name, "x"); !ok.ok()) return ok.error().message;
  }
  fs::create_hard_link(folder / "read.tumble", folder / "link.tumble", error);
  std::string found;
  for (const char* place : {"case/scene.toml", "case/metrics.toml", "case/expected.tumble", "case/frame_0001.png",
                            "read.tumble", "link.tumble", "kept/in/one.txt", "kept/new.txt", "plot.svg", "case",
                            "case/notes.txt", "case/new.png", "other.tumble", "scene.toml", "new.tumble"}) {
    found += (found.empty() ? "" : ", ") + std::string(place) + " " + guarded(folder, place);
  }
  return found;
}

// Bodies in a row before the camera; the pointer at parts of the picture's width and height.
render::Snapshot pointed_at() {
  render::Snapshot snapshot;
  snapshot.camera = {{0, -10, 2}, {0, 0, 2}, 60, 10, 0};
  const auto add = [&snapshot](std::uint64_t id, const Vec3& centre) {
    render::BoxLook& box = snapshot.boxes.emplace_back();
    box.id = id;
    box.centre = centre;
    box.half_extent = {0.5, 0.5, 1};
  };
  add(1, {-4, 0, 2});
  add(2, {0, 0, 2});
  add(3, {0, 3, 2});  // behind 2
  add(4, {4, 0, 5});
  add(5, {0, -10, 2});                                            // around the eye
  snapshot.boxes[3].orientation = sim::normalised({1, 0, 1, 0});  // lies along x
  return snapshot;
}

std::string pointers() {
  const render::Snapshot snapshot = pointed_at();
  const render::View view = render::camera_view(snapshot.camera, 400, 300);
  std::string found;
  for (const auto& [x, y] : {std::pair{0.5, 0.5},
                             {0.24, 0.5},
                             {0.76, 0.5},
                             {0.76, 0.24},
                             {0.82, 0.24},
                             {0.76, 0.15},
                             {0.24, 0.33},
                             {0.5, 0.58},
                             {0.5, 0.66}}) {
    const std::optional<render::Hit> hit = render::pick(snapshot, render::ray_through(view, x, y));
    found += (found.empty() ? "" : ", ") + (hit ? std::to_string(hit->id) + " at " + fixed(hit->distance, 2) : "none");
  }
  return found;
}

std::string depth_along_gaze() {
  return fixed(render::camera_view(pointed_at().camera, 400, 300).depth_of({3, 4, 5}), 3);
}

constexpr const char* kGuardedOutputs =
    "case/scene.toml refused, case/metrics.toml refused, case/expected.tumble refused, "
    "case/frame_0001.png refused, read.tumble refused, link.tumble refused, kept/in/one.txt refused, "
    "kept/new.txt refused, plot.svg refused, case refused, case/notes.txt written, case/new.png written, "
    "other.tumble written, scene.toml written, new.tumble written";

}  // namespace

void run_known_answers(CanaryRoll& roll) {
  texts(roll);
  roll.ask("a file is written where standard input is closed", written_without_input);
  roll.known("an output replaces no file of a case, of the command or of another output", outputs, kGuardedOutputs);
  roll.known("a pointer finds the nearest body", pointers,
             "2 at 9.50, 1 at 10.23, none, 4 at 10.62, 4 at 10.97, none, none, 2 at 9.54, none");
  roll.known("depth is along the gaze", depth_along_gaze, "14.000");
}

}  // namespace tumble::golden
