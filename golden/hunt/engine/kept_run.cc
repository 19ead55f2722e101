#include "golden/hunt/engine/kept_run.h"

#include <algorithm>
#include <fstream>
#include <ios>
#include <system_error>

#include "golden/engine/session_file.h"
#include "golden/suite/text_files.h"

namespace tumble::hunt {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWrote = "wrote";
constexpr const char* kSaid = "said";

struct Part {
  std::string bytes;
  bool cut = false;
};

// The first bytes of a file, or the last ones; nothing where there is no file.
Part part_of(const fs::path& file, std::uintmax_t most, bool last) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size == 0) return {};
  Part part{std::string(std::min(size, most), '\0'), size > most};
  std::ifstream in(file, std::ios::binary);
  if (last && part.cut) in.seekg(static_cast<std::streamoff>(size - most));
  in.read(part.bytes.data(), static_cast<std::streamsize>(part.bytes.size()));
  part.bytes.resize(static_cast<std::size_t>(in.gcount()));
  return part;
}

}  // namespace

void set_aside(const EngineFiles& ran, const fs::path& place) {
  std::error_code ignored;
  fs::create_directories(place, ignored);
  const auto how = fs::copy_options::overwrite_existing;
  if (fs::is_regular_file(ran.wrote, ignored)) fs::copy_file(ran.wrote, place / kWrote, how, ignored);
  if (fs::is_regular_file(ran.said, ignored)) fs::copy_file(ran.said, place / kSaid, how, ignored);
}

Result<std::vector<std::string>> keep_run(const fs::path& place, const fs::path& folder, const std::string& name) {
  std::vector<std::string> names;
  const auto keep = [&](const Part& part, const std::string& ending) -> Status {
    if (part.bytes.empty()) return {};
    names.push_back(name + ending + (part.cut ? ".cut" : ""));
    return golden::write_file(folder / names.back(), part.bytes);
  };
  const Part wrote = part_of(place / kWrote, kWroteBytesMost, false);
  if (Status ok = keep(wrote, golden::ending_of_session((place / kWrote).string())); !ok.ok()) return ok.error();
  if (Status ok = keep(part_of(place / kSaid, kSaidBytesMost, true), ".said.txt"); !ok.ok()) return ok.error();
  return names;
}

}  // namespace tumble::hunt
