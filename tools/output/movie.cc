#include "tools/output/movie.h"

#include <fstream>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "tools/output/text.h"

namespace tumble::tools {
namespace {

const std::vector<std::string> kMp4 = {"-c:v",     "libx264", "-preset",   "veryfast",   "-crf", "18",
                                       "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",   "mp4"};
const std::vector<std::string> kWebm = {"-c:v",     "libvpx-vp9", "-deadline", "realtime", "-cpu-used", "6",
                                        "-row-mt",  "1",          "-crf",      "28",       "-b:v",      "0",
                                        "-pix_fmt", "yuv420p",    "-f",        "webm"};

}  // namespace

bool Movie::is_movie(const std::string& path) { return path.ends_with(".mp4") || path.ends_with(".webm"); }

Status Movie::start(const std::string& path, int width, int height, double frames_per_second) {
  if (width % 2 != 0 || height % 2 != 0) {
    return bad_input("--size: found " + std::to_string(width) + "x" + std::to_string(height) +
                     ", wanted an even width and height for a movie");
  }
  path_ = path;
  Result<files::OutputFile> file = files::OutputFile::create(path);
  if (!file.ok()) return file.error();
  file_ = *std::move(file);
  std::vector<std::string> words = {"ffmpeg",   "-v",
                                    "error",    "-y",
                                    "-f",       "rawvideo",
                                    "-pix_fmt", "rgb24",
                                    "-s",       std::to_string(width) + "x" + std::to_string(height),
                                    "-r",       exact(frames_per_second),
                                    "-i",       "-",
                                    "-an"};
  const std::vector<std::string>& format = path.ends_with(".webm") ? kWebm : kMp4;
  words.insert(words.end(), format.begin(), format.end());
  words.push_back("file:" + file_->part());
  const std::string errors = folder_.path().empty() ? "" : (folder_.path() / "errors").string();
  return ffmpeg_.start(std::move(words), "movies", "ffmpeg", errors);
}

std::string Movie::said() const {
  std::ifstream file(folder_.path() / "errors", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Error Movie::failed() const {
  return cannot_finish(path_ + ": ffmpeg could not write it" + process::last_words(said()));
}

Status Movie::add(const render::Image& image) {
  if (ffmpeg_.write(std::as_bytes(std::span(image.rgb)))) return {};
  return failed();
}

Status Movie::finish() {
  // ffmpeg ends with status 0 also where the disk took only a part of its file; with -v error it prints errors alone.
  if (!ffmpeg_.finish() || !said().empty()) return failed();
  return file_->commit();
}

}  // namespace tumble::tools
