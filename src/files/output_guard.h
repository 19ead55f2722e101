#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "src/files/file_identity.h"
#include "tumble/sim/result.h"

namespace tumble::files {

/// Stands before all outputs of a command: none of them may replace a file that the command reads, a file of a golden
/// case, or another output of the command. Files are known by device and inode, so that links and other spellings of a
/// path are found. `bless` alone writes goldens, and asks no guard for them.
///
///     files::OutputGuard guard;
///     guard.keep(options.log, "the log that is measured");
///     if (Status ok = guard.claim("--series", options.series); !ok.ok()) return ok.error();
///
/// Asked before the work begins, so that a slip of the command line costs nothing.
class OutputGuard {
 public:
  /// The file must stay as it is. about: for messages: "the log that is measured". No effect where there is no file.
  void keep(const std::filesystem::path& path, const std::string& about);

  /// Every file in the folder and below must stay as it is, and no file may come in.
  void keep_folder(const std::filesystem::path& folder, const std::string& about);

  /// Asks to write one file. option: for messages: "--series". Errors (kBadInput): a kept file under any name, a place
  /// in a kept folder, a golden of any suite, a file claimed before, a folder.
  Status claim(const std::string& option, const std::filesystem::path& path);

  /// Asks to write files in a folder under names that are not known yet. Errors (kBadInput): the folder lies in a kept
  /// one, or holds a kept file or folder.
  Status claim_folder(const std::string& option, const std::filesystem::path& folder);

 private:
  struct Name {
    std::string path, about;  // for messages
    [[nodiscard]] std::string text(const std::filesystem::path& found) const;
  };
  using Kept = std::map<FileIdentity, Name>;
  [[nodiscard]] Status outside_kept_folders(const std::string& option, const std::filesystem::path& path) const;
  [[nodiscard]] Status holds_nothing_kept(const std::string& option, const std::filesystem::path& folder,
                                          std::set<FileIdentity>& seen) const;

  Kept files_, folders_;
  std::map<std::pair<FileIdentity, std::string>, std::string> claimed_;  // folder and name; the option
};

}  // namespace tumble::files
