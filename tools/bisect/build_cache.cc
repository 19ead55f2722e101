#include "tools/bisect/build_cache.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <span>
#include <system_error>
#include <vector>

#include "golden/bundle/file_hashes.h"
#include "golden/suite/text_files.h"
#include "tools/bisect/workplace.h"
#include "tumble/golden/provenance.h"
#include "tumble/sim/hash.h"

namespace tumble::tools::bisect {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "program";
constexpr const char* kHash = "hash";
constexpr std::size_t kKeyLength = 16;

struct Kept {
  fs::path folder;
  fs::file_time_type used;
  std::uint64_t bytes = 0;
};

/// Programs that are kept; what else lies in the folder is not touched.
std::vector<Kept> kept_in(const std::string& folder) {
  std::vector<Kept> all;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code missing;
    Kept one{at->path(), fs::last_write_time(at->path() / kHash, missing), 0};
    if (!missing) one.bytes = fs::file_size(at->path() / kProgram, missing);
    if (!missing) all.push_back(one);
  }
  return all;
}

}  // namespace

Result<BuildCache> BuildCache::open(const Settings& settings) {
  if (Status ok = make_private(settings.cache, "--cache"); !ok.ok()) return ok.error();
  std::string text = golden::this_program().machine + '\n' + settings.program;
  for (const std::string& command : settings.build) text += '\n' + command;
  BuildCache cache;
  cache.folder_ = settings.cache;
  cache.key_ = to_string(hash_bytes(std::as_bytes(std::span(text)))).substr(0, kKeyLength);
  cache.bytes_max_ = settings.cache_bytes;
  return cache;
}

bool BuildCache::take(const std::string& commit, const std::string& to) const {
  const fs::path from = place(commit);
  std::error_code error;
  const Result<std::string> wanted = golden::read_text(from / kHash);
  if (!wanted.ok()) return false;
  fs::create_directories(fs::path(to).parent_path(), error);
  fs::remove(to, error);
  fs::copy_file(from / kProgram, to, error);
  const Result<golden::FileHash> found = golden::hash_file(to);
  if (error || !found.ok()) return false;  // a full disk, say
  if (found->hash != *wanted) {
    fs::remove_all(from, error);
    return false;
  }
  fs::last_write_time(from / kHash, fs::file_time_type::clock::now(), error);
  return true;
}

Status BuildCache::keep(const std::string& commit, const std::string& program) const {
  static std::atomic<unsigned> count{0};
  const Result<golden::FileHash> hash = golden::hash_file(program);
  if (!hash.ok()) return cannot_finish("--cache: " + hash.error().message);
  if (hash->bytes > bytes_max_) return {};
  const std::string part = folder_ + "/part-" + std::to_string(::getpid()) + '-' + std::to_string(count++);
  std::error_code error, ignored;
  fs::create_directory(part, error);
  if (!error) fs::copy_file(program, fs::path(part) / kProgram, error);
  Status written = error ? Status(cannot_finish(part + ": cannot be written: " + error.message()))
                         : golden::write_file(fs::path(part) / kHash, std::string_view(hash->hash));
  if (written.ok()) {
    fs::remove_all(place(commit), ignored);
    fs::rename(part, place(commit), error);
    make_room();
  }
  fs::remove_all(part, ignored);  // also where another bisection was faster
  return written;
}

void BuildCache::make_room() const {
  std::vector<Kept> all = kept_in(folder_);
  std::ranges::sort(all, std::ranges::greater(), &Kept::used);
  std::uint64_t bytes = 0;
  for (const Kept& one : all) {
    bytes += one.bytes;
    std::error_code ignored;
    if (bytes > bytes_max_) fs::remove_all(one.folder, ignored);
  }
}

}  // namespace tumble::tools::bisect
