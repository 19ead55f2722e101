#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "golden/suite/temporary_folder.h"
#include "tumble/sim/result.h"

namespace tumble::hunt {

/// What an engine left of one run; its folder goes with the last that holds this.
struct EngineFiles {
  explicit EngineFiles(const std::filesystem::path& scratch) : folder("scene", scratch) {}
  golden::TemporaryFolder folder;
  std::filesystem::path
      wrote;                   ///< the session as the engine wrote it: a log, a stream, a table or an archive of arrays
  std::filesystem::path said;  ///< its standard output and standard error
};

/// Of each file at most so many bytes are kept: of a session the first ones, of what an engine printed the last.
inline constexpr std::uintmax_t kWroteBytesMost = 4 << 20;
inline constexpr std::uintmax_t kSaidBytesMost = 64 << 10;

/// Copies what a run left to another folder, which is made. A file that cannot be copied is left out.
void set_aside(const EngineFiles& ran, const std::filesystem::path& place);

/// Copies what set_aside() put into `place` to NAME.tumble, NAME.tumblestream, NAME.npz or NAME.csv, and to
/// NAME.said.txt, in `folder`; a file of which not all is kept ends in ".cut". Returns the names; empty files have
/// none. Errors (kCannotFinish): the disk.
Result<std::vector<std::string>> keep_run(const std::filesystem::path& place, const std::filesystem::path& folder,
                                          const std::string& name);

}  // namespace tumble::hunt
