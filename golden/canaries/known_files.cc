#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "golden/canaries/known_answers.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/files/file_kind.h"
#include "src/files/file_lock.h"
#include "src/files/output_file.h"
#include "src/files/output_guard.h"
#include "tumble/process/job_pool.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;
using files::FileKind;
using namespace std::string_literals;

constexpr std::array kEndings = {".csv", ".glb", ".html", ".JSON", ".mcap", ".mp4",
                                 ".npz", ".png", ".svg",  ".webm", ".xml"};
constexpr std::size_t kKinds = 12;  // of FileKind, in its order: the endings with probes before SVG

// A beginning of a file, and the kinds of output that may replace it.
struct Beginning {
  const char* name;
  std::string bytes;
  const char* kinds;
};
const auto& beginnings() {
  static const std::array kBeginnings = {
      Beginning{"nothing", "", "0 1 2 3 4 5 6 7 8 9 10 11 "},
      Beginning{"a table", "step,id\n", "0 "},
      Beginning{"a table with a head", "# engine: a\n# b\nstep,id\n", "0 "},
      Beginning{"a head alone", "# engine: a", ""},
      Beginning{"a table of others", "id,step\n", ""},
      Beginning{"glTF", "glTF\2\0"s, "1 "},
      Beginning{"a page", std::string(files::kPageBegins), "2 "},
      Beginning{"a page of others", "<!doctype html>\n<html>", ""},
      Beginning{"JSON", " \n{\"a\": 1}", "3 "},
      Beginning{"JSON of a list", "[1]", "3 "},
      Beginning{"MCAP", "\x89MCAP0\r\n", "4 "},
      Beginning{"MP4", "\0\0\0 ftypisom"s, "5 "},
      Beginning{"an archive", "PK\3\4", "6 "},
      Beginning{"an empty archive", "PK\5\6", "6 "},
      Beginning{"PNG", "\x89PNG\r\n\x1a\n", "7 "},
      Beginning{"probes", "TMBLPRB1", "8 "},
      Beginning{"SVG", "<?xml version=\"1.0\"?>\n<svg>", "9 "},
      Beginning{"WebM", "\x1a\x45\xdf\xa3", "10 "},
      Beginning{"JUnit", "<testsuites>", "11 "},
      Beginning{"a text", "int main() {}", ""},
      Beginning{"bytes", "{\0\1\2"s, ""},
  };
  return kBeginnings;
}

std::string kinds_by_name() {
  std::string found;
  for (const char* ending : kEndings)
    found += std::to_string(static_cast<int>(files::kind_by_name("a/b"s + ending))) + " ";
  return found;
}

std::string kinds_replaced(const fs::path& folder) {
  for (const Beginning& one : beginnings()) {
    const fs::path path = folder / "old";
    if (const Status ok = write_file(path, one.bytes); !ok.ok()) return ok.error().message;
    std::string found;
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      if (files::replaces_its_kind("-o", path, static_cast<FileKind>(kind)).ok()) found += std::to_string(kind) + " ";
    }
    if (found != one.kinds) return one.name + ": "s + found;
  }
  const Status refused = files::replaces_its_kind("-o", folder / "old", FileKind::kPng);
  return refused.ok() ? "as known" : refused.error().message.substr(folder.string().size() + 4);
}

std::string file_read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A file appears when it is complete, and only then; what a killed process left behind goes.
std::string file_written(const fs::path& folder) {
  const fs::path path = folder / "out", link = folder / "link", left = folder / "out.part-999999999-0",
                 other = folder / "out.part-x";
  for (const fs::path& file : {path, left, other}) {
    if (const Status ok = write_file(file, "old"); !ok.ok()) return ok.error().message;
  }
  std::error_code error;
  fs::create_symlink("out", link, error);
  ::chmod(path.c_str(), 0640);
  std::string found;
  {
    Result<files::OutputFile> file = files::OutputFile::create(link.string());
    if (!file.ok()) return file.error().message;
    if (!file->write("new").ok() || !file->write(std::string(70'000, 'x')).ok()) return "not written";
    found += file_read(path) + " ";
  }
  found += file_read(path) + " ";  // not committed
  Result<files::OutputFile> file = files::OutputFile::create(link.string());
  if (!file.ok() || !file->write("news").ok() || !file->write_at(1, "EW").ok() || !file->commit().ok())
    return "not written";
  struct stat info = {};
  ::stat(path.c_str(), &info);
  found += file_read(path) + (fs::is_symlink(link) ? " by its link, mode " : " as a file, mode ") +
           std::to_string(info.st_mode & 0777U);
  found += fs::exists(left) ? ", a part is left" : ", no part is left";
  found += fs::exists(other) ? ", another's stays" : ", another's is gone";
  for (const fs::path& at : {folder, folder / "no/where", fs::path("/dev/null")}) {
    const Result<files::OutputFile> made = files::OutputFile::create(at.string());
    found += made.ok() ? made->is_device() ? ", a device" : ", a file"
                       : ", " + made.error().message.substr(at.string().size());
  }
  return found;
}

// This process as others are told of it, as far as the system shows its command line and the line is short.
std::string this_process() {
  std::string number = "process " + std::to_string(::getpid());
  std::string line = file_read("/proc/self/cmdline");
  if (line.empty() || line.size() > 150) return number;
  line.pop_back();  // each word ends with a zero
  std::ranges::replace(line, '\0', ' ');
  return number + " (" + printable(line) + "); wait";
}

// The rights of a lock's file, where the process takes none away.
std::string rights_of_lock(const fs::path& folder) {
  ::umask(0);
  const Result<files::FolderLock> taken = files::FolderLock::take(folder, "a.lock", "a hunt");
  struct stat info = {};
  ::stat((folder / "a.lock").c_str(), &info);
  return taken.ok() ? ", mode " + std::to_string(info.st_mode & 0777U) : taken.error().message;
}

std::string folder_locked(const fs::path& folder) {
  std::string found;
  Result<files::FolderLock> first = files::FolderLock::take(folder / "locked", "a.lock", "a hunt");
  if (!first.ok()) return first.error().message;
  files::FolderLock held = std::move(*first);
  const std::string refused = (folder / "locked").string() + ": a hunt works there, " + this_process();
  process::run_jobs(
      1,
      [&](std::size_t) {
        const Result<files::FolderLock> second = files::FolderLock::take(folder / "locked", "a.lock", "a hunt");
        if (second.ok()) return "taken twice"s;
        const std::string& said = second.error().message;
        return (said.starts_with(refused) ? "refused, with the process" : said) + rights_of_lock(folder / "free");
      },
      [&](std::size_t, const process::JobResult& child) { found = child.failure + child.output; }, {});
  { const files::FolderLock gone = std::move(held); }
  const Result<files::FolderLock> again = files::FolderLock::take(folder / "locked", "a.lock", "a hunt");
  return found + (again.ok() ? ", taken later" : ", never taken again");
}

std::string folder_claimed(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder / "suite/case/deep", error);
  fs::create_directories(folder / "free/deep", error);
  if (!write_file(folder / "suite/case/deep/log", "x").ok()) return "not written";
  files::OutputGuard guard;
  guard.keep(folder / "suite/case/deep/log", "the log that is read");
  guard.keep_folder(folder / "suite/case", "the case");
  std::string found;
  for (const char* place : {"suite", "suite/case", "suite/case/deep", "free", "free/deep", "new"}) {
    const Status ok = guard.claim_folder("--report", folder / place);
    found += place + (ok.ok() ? " taken, "s : " refused, "s);
  }
  return found;
}

// Files of a folder that is kept, by other ways to them: a hard link from without, a folder that a link leads to.
std::string links_claimed(const fs::path& folder) {
  std::error_code error;
  for (const char* place : {"kept/deep", "far", "beside"}) fs::create_directories(folder / place, error);
  for (const char* file : {"kept/top", "kept/deep/log", "far/file"}) {
    if (!write_file(folder / file, "x").ok()) return "not written";
  }
  fs::create_hard_link(folder / "kept/top", folder / "beside/top", error);
  fs::create_hard_link(folder / "kept/deep/log", folder / "beside/log", error);
  fs::create_directory_symlink(folder / "far", folder / "kept/link", error);
  if (error) return "as known";  // no links there
  files::OutputGuard guard;
  guard.keep_folder(folder / "kept", "the case");
  std::string found;
  for (const char* place : {"kept/top", "kept/deep/log", "kept/deep/new", "kept/link/file", "far/file", "far/new",
                            "beside/top", "beside/log", "beside/new"}) {
    const Status ok = guard.claim("-o", folder / place);
    found += place + (ok.ok() ? " taken, "s : " refused, "s);
  }
  const bool known = found ==
                     "kept/top refused, kept/deep/log refused, kept/deep/new refused, kept/link/file refused, "
                     "far/file refused, far/new refused, beside/top refused, beside/log refused, beside/new taken, ";
  return known ? "as known" : found;
}

// Two links that lead to one another: an output by them is made or refused within seconds.
std::string links_in_a_circle(const fs::path& folder) {
  std::error_code error;
  fs::create_symlink("b", folder / "a", error);
  fs::create_symlink("a", folder / "b", error);
  if (error) return "as known";  // no links there
  process::PoolOptions options;
  options.cpu_s = 5;
  std::string found;
  process::run_jobs(
      1,
      [&folder](std::size_t) {
        const Result<files::OutputFile> file = files::OutputFile::create((folder / "a").string());
        return file.ok() ? "as known" : file.error().message;
      },
      [&found](std::size_t, const process::JobResult& child) { found = child.failure + child.output; }, options);
  return found;
}

// In an empty folder of its own.
template <class Find>
auto in_scratch(Find find) {
  return [find]() -> std::string {
    const TemporaryFolder scratch("tumble-canary");
    return scratch.path().empty() ? "no temporary folder could be made" : find(scratch.path());
  };
}

}  // namespace

void run_known_files(CanaryRoll& roll) {
  roll.known("the name of an output chooses its kind", kinds_by_name, "0 1 2 3 4 5 6 7 9 10 11 ");
  roll.known("an output replaces its own kind alone", in_scratch(kinds_replaced),
             "/old: exists and is no PNG picture, so no earlier output; name another file, or remove it first");
  roll.known("a file appears when it is complete", in_scratch(file_written),
             "old old news by its link, mode 416, no part is left, another's stays, : is a folder; name a file, : "
             "cannot be written: No such file or directory, a device");
  roll.known("a folder is one process's at a time", in_scratch(folder_locked),
             "refused, with the process, mode 438, taken later");
  roll.known("a folder of outputs holds nothing that must stay", in_scratch(folder_claimed),
             "suite refused, suite/case refused, suite/case/deep refused, free taken, free/deep taken, new taken, ");
  roll.known("links in a circle end", in_scratch(links_in_a_circle));
  roll.known("a file that must stay is found by every way to it", in_scratch(links_claimed));
}

}  // namespace tumble::golden
