#include "tools/view/http_server.h"

#if TUMBLE_HTTP
#include <httplib.h>
#include <sys/random.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <thread>
#include <utility>

#include "src/base/text.h"
#include "src/process/interrupt.h"
#endif

namespace tumble::tools {

#if TUMBLE_HTTP
namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kWorkers = 32;  // a browser holds up to 6 connections, and a slow question its worker
constexpr std::size_t kRequestsPerConnection = 10'000;
constexpr int kPatience = 5;  // s, for a client that sends or reads slowly
constexpr int kKeepOpen = 2;  // s; an idle connection holds a worker no longer
constexpr auto kPause = std::chrono::milliseconds(50);

/// 128 random bits in hexadecimal digits.
Result<std::string> make_token() {
  std::array<char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    return cannot_finish("view: the system gave no random numbers for the address of the page");
  }
  return hex_digits({bytes.data(), bytes.size()});
}

/// Takes the same time whichever character differs.
bool same_token(const std::string& one, const std::string& other) {
  if (one.size() != other.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    different |= static_cast<unsigned>(static_cast<unsigned char>(one[i])) ^ static_cast<unsigned char>(other[i]);
  }
  return different == 0;
}

/// Answers are made by whichever worker is free. With a heap for each of them the library would keep the memory that
/// one state takes as often as there are workers.
void share_one_heap() {
#if defined(__GLIBC__)
  (void)::mallopt(M_ARENA_MAX, 1);
#endif
}

class Server {
 public:
  Server(SessionService& service, std::string token, std::string policy)
      : service_(service), token_(std::move(token)), policy_(std::move(policy)) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kWorkers); };
    server_.set_keep_alive_max_count(kRequestsPerConnection);
    server_.set_keep_alive_timeout(kKeepOpen);
    server_.set_read_timeout(kPatience);
    server_.set_write_timeout(kPatience);
    server_.set_payload_max_length(0);
    server_.set_tcp_nodelay(true);
    // SO_REUSEADDR alone: the library's own choice, SO_REUSEPORT, would let another process share the port.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      answer(request, response);
      return httplib::Server::HandlerResponse::Handled;
    });
    server_.set_exception_handler(
        [](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) { response.status = 500; });
  }

  Status bind(std::optional<std::uint64_t> port) {
    if (port) {
      if (!server_.bind_to_port(kHost, static_cast<int>(*port))) {
        return bad_input("--port: port " + std::to_string(*port) +
                         " is taken or not allowed; leave --port out for a free one");
      }
      port_ = static_cast<int>(*port);
    } else {
      port_ = server_.bind_to_any_port(kHost);
      if (port_ <= 0) return cannot_finish("view: the system gave no free port on 127.0.0.1");
    }
    return {};
  }

  [[nodiscard]] std::string address() const {
    return "http://" + std::string(kHost) + ":" + std::to_string(port_) + "/" + token_ + "/";
  }

  Status run(const std::function<void(const std::string&)>& ready) {
    std::atomic<bool> ended = false;
    bool fine = true;
    std::thread listener([&] {
      fine = server_.listen_after_bind();
      ended = true;
    });
    ready(address());
    while (!ended && !process::InterruptGuard::interrupted()) std::this_thread::sleep_for(kPause);
    // stop() does nothing before the listener runs.
    while (!ended) {
      server_.stop();
      std::this_thread::sleep_for(kPause);
    }
    listener.join();
    if (!fine && !process::InterruptGuard::interrupted()) return cannot_finish("view: the server ended by itself");
    return {};
  }

 private:
  /// A page of another site may name this server by a host name of its own; its requests have that name as their Host.
  [[nodiscard]] bool has_own_host(const httplib::Request& request) const {
    if (request.get_header_value_count("Host") != 1) return false;
    const std::string host = request.get_header_value("Host"), port = ":" + std::to_string(port_);
    return host == kHost + port || host == "localhost" + port;
  }

  void answer(const httplib::Request& request, httplib::Response& response) {
    response.set_header("Content-Security-Policy", policy_);
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("X-Frame-Options", "DENY");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    response.set_header("Cross-Origin-Opener-Policy", "same-origin");
    response.set_header("Cache-Control", "no-store");
    const auto refuse = [&](int status, const char* words) {
      response.status = status;
      response.set_content(words, "text/plain");
    };
    if (!has_own_host(request)) return refuse(403, "the Host of the request is not this server's\n");
    const std::size_t end = 1 + token_.size();
    const std::string& path = request.path;
    const bool has_token =
        path.size() > end && path[0] == '/' && path[end] == '/' && same_token(path.substr(1, token_.size()), token_);
    if (!has_token) return refuse(403, "the address lacks the token that 'tumble view' printed\n");
    if (request.method != "GET" && request.method != "HEAD") return refuse(405, "only GET\n");
    const auto reply = std::make_shared<const Reply>(service_.answer(path.substr(end + 1), request.params));
    response.status = reply->status;
    // By set_content() the library would compress it, which takes a second for the page: more than any loopback needs.
    response.set_content_provider(reply->body.size(), reply->type,
                                  [reply](std::size_t from, std::size_t count, httplib::DataSink& sink) {
                                    return sink.write(reply->body.data() + from, count);
                                  });
  }

  SessionService& service_;
  std::string token_, policy_;
  int port_ = 0;
  httplib::Server server_;
};

}  // namespace

bool has_http_server() { return true; }

struct HttpClient::Connection {
  explicit Connection(const std::string& host) : client(host) {}
  httplib::Client client;
  std::string path;
};

HttpClient::HttpClient(const std::string& address, double patience_s) {
  const std::size_t path = address.find('/', std::string("http://").size());
  connection_ = std::make_unique<Connection>(address.substr(0, path));
  connection_->path = path == std::string::npos ? "/" : address.substr(path);
  connection_->client.set_read_timeout(static_cast<time_t>(patience_s));
  connection_->client.set_keep_alive(true);
  connection_->client.set_tcp_nodelay(true);
}
HttpClient::~HttpClient() = default;

Result<std::string> HttpClient::get(const std::string& question) {
  const httplib::Result reply = connection_->client.Get(connection_->path + question);
  if (!reply || reply->status != 200) return cannot_finish("view: the server does not answer \"" + question + '"');
  return reply->body;
}

Status serve_http(SessionService& service, std::optional<std::uint64_t> port, const std::string& policy,
                  const std::function<void(const std::string& address)>& ready) {
  Result<std::string> token = make_token();
  if (!token.ok()) return token.error();
  share_one_heap();
  Server server(service, *std::move(token), policy);
  if (Status ok = server.bind(port); !ok.ok()) return ok;
  return server.run(ready);
}

#else

bool has_http_server() { return false; }

struct HttpClient::Connection {};
HttpClient::HttpClient(const std::string& /*address*/, double /*patience_s*/) {}
HttpClient::~HttpClient() = default;
Result<std::string> HttpClient::get(const std::string& /*question*/) {
  return cannot_finish("view: this program was built without libcpp-httplib-dev");
}

Status serve_http(SessionService& /*service*/, std::optional<std::uint64_t> /*port*/, const std::string& /*policy*/,
                  const std::function<void(const std::string& address)>& /*ready*/) {
  return cannot_finish(
      "view: this program was built without libcpp-httplib-dev and cannot serve the page; write it with -o FILE.html");
}

#endif

}  // namespace tumble::tools
