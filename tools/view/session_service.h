#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tools/view/served_log.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The answer to one request.
struct Reply {
  int status = 200;
  std::string type = "application/json";
  std::string body;
};

/// Answers what the session page asks of one log or of two. Knows nothing of HTTP, reads nothing but these logs, and
/// does a bounded amount of work for each question. May be asked from any thread.
///
///   ""            the page            news?log=L         bodies?log=L      timeline?log=L&from=ROW
///   begun?log=L&from=ROW              blame?log=L&step=K&id=ID&field=NAME&back=ANSWERS
///   frames?log=L&first=K&count=N&stride=S     contacts?log=L&step=K        body?log=L&step=K&id=ID
///   way?log=L&id=ID                   difference         head?log=L
class SessionService {
 public:
  using Parameters = std::multimap<std::string, std::string>;

  /// Starts reading the logs, one or two.
  explicit SessionService(std::vector<replay::LogReader> logs, const std::vector<replay::ViewedBound>& bounds = {});
  ~SessionService();
  SessionService(const SessionService&) = delete;
  SessionService& operator=(const SessionService&) = delete;

  /// path: the part of the address behind the token. Status 404: no such question; 400: a parameter that is missing or
  /// no whole number in its range.
  Reply answer(const std::string& path, const Parameters& parameters);

 private:
  Reply page();
  std::string difference();
  void compare();  // in a thread of its own

  std::vector<std::unique_ptr<ServedLog>> logs_;
  std::vector<std::string> paths_, bounds_;
  std::mutex found_;        // guards what follows
  std::string difference_;  // JSON; empty: not compared yet
  double compared_ = 0;     // the share of the work done
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace tumble::tools
