#pragma once

#ifdef __FAST_MATH__
#error "results of Tumble are exact bits: compile without -ffast-math (-Ofast), which changes the arithmetic of the whole process"
#endif

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace tumble {

/// The kinds of errors that the exit status of the command line tells apart.
enum class ErrorKind {
  kBadInput,      ///< exit 2: a file or an argument is wrong
  kDamaged,       ///< exit 3: a file was valid once and is no longer
  kCannotFinish,  ///< exit 4: disk, memory, a non-finite state, an internal check
};

/// An error and its message. The message names the file, the place, what was found, what was wanted, and what to do.
struct Error {
  ErrorKind kind = ErrorKind::kBadInput;
  std::string message;
};

/// A value or an Error. No exception crosses the interfaces of this project.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}

  [[nodiscard]] bool ok() const { return std::holds_alternative<T>(content_); }
  explicit operator bool() const { return ok(); }

  T& operator*() & { return std::get<T>(content_); }
  const T& operator*() const& { return std::get<T>(content_); }
  T&& operator*() && { return std::get<T>(std::move(content_)); }
  T* operator->() { return &std::get<T>(content_); }
  const T* operator->() const { return &std::get<T>(content_); }

  [[nodiscard]] const Error& error() const { return std::get<Error>(content_); }

 private:
  std::variant<T, Error> content_;
};

/// Success, or an Error.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}

  [[nodiscard]] bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

inline Error bad_input(std::string message) { return {ErrorKind::kBadInput, std::move(message)}; }
inline Error damaged(std::string message) { return {ErrorKind::kDamaged, std::move(message)}; }
inline Error cannot_finish(std::string message) { return {ErrorKind::kCannotFinish, std::move(message)}; }

}  // namespace tumble
