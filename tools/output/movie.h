#pragma once

#include <optional>
#include <string>

#include "golden/suite/temporary_folder.h"
#include "src/files/output_file.h"
#include "src/process/child_pipe.h"
#include "tumble/render/image.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Writes a movie: frames go through a pipe into ffmpeg, which runs beside. The file gets its name when it is complete.
class Movie {
 public:
  Movie() = default;
  ~Movie() = default;  ///< discards a movie that was not finished
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// Starts ffmpeg. path: ends with .mp4 (H.264) or .webm (VP9). Errors: an odd width or height, which the formats'
  /// colours do not allow (kBadInput); no ffmpeg (kCannotFinish); OutputFile's.
  Status start(const std::string& path, int width, int height, double frames_per_second);
  Status add(const render::Image& image);
  /// Waits until ffmpeg is done. Errors (kCannotFinish): it failed; the message has its own.
  Status finish();

  [[nodiscard]] static bool is_movie(const std::string& path);

 private:
  [[nodiscard]] Error failed() const;
  [[nodiscard]] std::string said() const;

  std::string path_;
  golden::TemporaryFolder folder_{"tumble-movie"};  // of ffmpeg's errors
  std::optional<files::OutputFile> file_;
  process::ChildPipe ffmpeg_;  // ends before its file is discarded
};

}  // namespace tumble::tools
