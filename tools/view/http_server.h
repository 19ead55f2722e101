#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "tools/view/session_service.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// Whether this program was built with libcpp-httplib-dev, and can serve pages at all.
bool has_http_server();

/// Asks a server that serve_http() runs, one question after the other over one connection.
class HttpClient {
 public:
  /// address: as serve_http() gave it. patience_s: that a reply may take.
  HttpClient(const std::string& address, double patience_s);
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  /// The body of the reply to "frames?log=0&…". Errors (kCannotFinish): none, or one with another status than 200.
  Result<std::string> get(const std::string& question);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

/// Serves a session on 127.0.0.1 until Ctrl-C, SIGTERM or SIGHUP (an InterruptGuard must exist). Only requests that
/// name this server's own Host and carry the token in their path are answered, only GET and HEAD, none with a body;
/// every reply forbids other pages to read it.
///
/// port: none: any free one. ready: called once with the address, "http://127.0.0.1:PORT/TOKEN/". policy: the
/// Content-Security-Policy of replies. Errors: kBadInput: the port is taken; kCannotFinish: built without a server, no
/// random numbers, no socket.
Status serve_http(SessionService& service, std::optional<std::uint64_t> port, const std::string& policy,
                  const std::function<void(const std::string& address)>& ready);

}  // namespace tumble::tools
