#include "tools/movie.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <vector>

#include "tools/text.h"

extern char** environ;  // NOLINT: POSIX asks for this declaration

namespace tumble::tools {
namespace {

const std::vector<std::string> kMp4 = {"-c:v",     "libx264", "-preset",   "veryfast",   "-crf", "18",
                                       "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f",   "mp4"};
const std::vector<std::string> kWebm = {"-c:v",     "libvpx-vp9", "-deadline", "realtime", "-cpu-used", "6",
                                        "-row-mt",  "1",          "-crf",      "28",       "-b:v",      "0",
                                        "-pix_fmt", "yuv420p",    "-f",        "webm"};

// Starts `words` with `input` as its standard input; 0 or an errno.
int spawn(std::vector<std::string> words, int input, pid_t& child) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  // Ctrl-C is for us alone: ffmpeg ends when its input does.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

bool Movie::is_movie(const std::string& path) { return path.ends_with(".mp4") || path.ends_with(".webm"); }

Status Movie::start(const std::string& path, int width, int height, double frames_per_second) {
  if (width % 2 != 0 || height % 2 != 0) {
    return bad_input("--size: found " + std::to_string(width) + "x" + std::to_string(height) +
                     ", wanted an even width and height for a movie");
  }
  path_ = path;
  part_ = path + ".part";
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
  words.push_back("file:" + part_);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return cannot_finish(std::string("no pipe to ffmpeg: ") + std::strerror(errno));
  const int error = spawn(words, ends[0], child_);
  close(ends[0]);
  pipe_ = ends[1];
  if (error == 0) {
    std::signal(SIGPIPE, SIG_IGN);  // an ffmpeg that ends early is an error of write(), not our end
    return {};
  }
  child_ = -1;
  if (error == ENOENT)
    return cannot_finish("movies need ffmpeg, which is not installed (Debian: apt-get install ffmpeg)");
  return cannot_finish(std::string("ffmpeg cannot be started: ") + std::strerror(error));
}

Error Movie::failed() const { return cannot_finish(path_ + ": ffmpeg could not write it; its words are above"); }

Status Movie::add(const render::Image& image) {
  const std::uint8_t* data = image.rgb.data();
  std::size_t left = image.rgb.size();
  while (left > 0) {
    const ssize_t written = write(pipe_, data, left);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return failed();
    data += written;
    left -= static_cast<std::size_t>(written);
  }
  return {};
}

int Movie::wait() {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  int status = -1;
  if (child_ > 0) {
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  child_ = -1;
  return status;
}

Status Movie::finish() {
  if (wait() == 0 && std::rename(part_.c_str(), path_.c_str()) == 0) return {};
  std::remove(part_.c_str());
  return failed();
}

Movie::~Movie() {
  if (child_ < 0) {
    if (pipe_ >= 0) close(pipe_);
    return;
  }
  kill(child_, SIGTERM);
  static_cast<void>(wait());
  std::remove(part_.c_str());
}

}  // namespace tumble::tools
