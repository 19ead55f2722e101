#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <streambuf>
#include <string_view>

/// Names in files are anybody's: written as they are, their escape sequences would drive the terminal.
namespace tumble::tools {

/// Passes text on to another buffer. Each control character but newline and tab, each broken UTF-8
/// character, and each character that turns the direction of writing becomes '?'.
class CleanBuffer : public std::streambuf {
 public:
  explicit CleanBuffer(std::streambuf* target) : target_(target) {}
  ~CleanBuffer() override { end_character(); }
  CleanBuffer(const CleanBuffer&) = delete;
  CleanBuffer& operator=(const CleanBuffer&) = delete;

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override { return target_->pubsync(); }

 private:
  bool put(char c);
  bool put_text(std::string_view text);
  bool end_character();  ///< which was cut short

  std::streambuf* target_;
  std::array<char, 4> held_ = {};  // the begin of a character
  std::size_t held_size_ = 0;
};

/// While it lives, a stream writes through a CleanBuffer. What a program writes to a terminal on purpose, such as a
/// progress bar, goes to std::clog, which stays as it is.
class CleanStream {
 public:
  explicit CleanStream(std::ostream& stream)
      : stream_(stream), clean_(stream.rdbuf()), before_(stream.rdbuf(&clean_)) {}
  ~CleanStream() { stream_.rdbuf(before_); }
  CleanStream(const CleanStream&) = delete;
  CleanStream& operator=(const CleanStream&) = delete;

 private:
  std::ostream& stream_;
  CleanBuffer clean_;
  std::streambuf* before_;
};

}  // namespace tumble::tools
