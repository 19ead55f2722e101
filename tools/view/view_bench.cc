#include "tools/view/view_bench.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

#include "golden/suite/temporary_folder.h"
#include "src/process/run_child.h"
#include "tools/view/http_server.h"

namespace tumble::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr unsigned kSide = 80;  // of the square of cubes
constexpr std::uint64_t kSteps = 1500;
constexpr std::size_t kSeeks = 40, kContacts = 8;
constexpr double kOpenMost = 1, kSeekMost = 0.1, kPatience = 600;  // s
constexpr double kMegabytesMost = 500;
constexpr auto kBetween = std::chrono::milliseconds(20);

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A folder that goes with this object, and the server in it.
class ServerPlace {
 public:
  ServerPlace() = default;
  ~ServerPlace() { end_server(); }
  ServerPlace(const ServerPlace&) = delete;
  ServerPlace& operator=(const ServerPlace&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return (folder_.path() / name).string(); }

  /// Runs this program to its end.
  [[nodiscard]] Status run(std::vector<std::string> words) const {
    const Result<process::ChildEnd> end = process::run_child(program_of(std::move(words)), kPatience);
    if (!end.ok()) return end.error();
    return end->well() ? Status() : Status(cannot_finish("view: tumble " + end->text() + ": " + text("err")));
  }

  Status start_server(std::vector<std::string> words) {
    fs::remove(file("out"));
    if (process::start(program_of(std::move(words)), server_) != 0) return cannot_finish("view: no server starts");
    return {};
  }
  void end_server() {
    if (server_ == 0) return;
    process::signal_group(server_, SIGINT);
    process::wait_for_group(std::exchange(server_, 0));
  }

  /// The address that the server has printed; empty: not yet.
  [[nodiscard]] std::string address() const {
    const std::string said = text("out");
    const std::size_t end = said.find('\n');
    return end == std::string::npos ? "" : said.substr(0, end);
  }
  /// Of the server, in MB, at most so far.
  [[nodiscard]] double memory() const {
    std::ifstream status("/proc/" + std::to_string(server_) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024 / 1e6;
    }
    return 0;
  }
  /// CPU seconds of the server so far.
  [[nodiscard]] double cpu() const {
    std::ifstream stat("/proc/" + std::to_string(server_) + "/stat");
    std::string line;
    std::getline(stat, line);
    std::istringstream fields(line.substr(std::min(line.size(), line.rfind(')') + 1)));
    const std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
    if (words.size() < 13) return 0;
    return (std::stod(words[11]) + std::stod(words[12])) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }

 private:
  [[nodiscard]] std::string text(const char* name) const { return printed_in(file(name)); }
  [[nodiscard]] process::Program program_of(std::vector<std::string> words) const {
    process::Program program;
    std::error_code error;
    program.words = {fs::read_symlink("/proc/self/exe", error).string()};
    program.words.insert(program.words.end(), words.begin(), words.end());
    program.out = file("out");
    program.err = file("err");
    return program;
  }

  golden::TemporaryFolder folder_{"tumble_bench_view"};
  pid_t server_ = 0;
};

/// The body of a reply, and the seconds that it took.
Result<std::pair<std::string, double>> timed(HttpClient& client, const std::string& question) {
  const Clock::time_point start = Clock::now();
  Result<std::string> body = client.get(question);
  if (!body.ok()) return body.error();
  return std::pair(*std::move(body), seconds_since(start));
}

double at_share(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Single states, each in another chunk than the one before.
Result<Json> seek(HttpClient& client, const ServerPlace& place) {
  const double cpu = place.cpu();
  std::vector<double> seconds;
  for (std::size_t i = 0; i < kSeeks; ++i) {
    const std::uint64_t step = (i * 617 + 311) % (kSteps + 1);
    const auto frame = timed(client, "frames?log=0&count=1&stride=1&first=" + std::to_string(step));
    if (!frame.ok()) return frame.error();
    seconds.push_back(frame->second);
  }
  return Json{{"median", median(seconds)},
              {"p90", at_share(seconds, 0.9)},
              {"most", at_share(seconds, 1)},
              {"cpu_each", (place.cpu() - cpu) / static_cast<double>(kSeeks)}};
}

/// The contacts of single steps, which the server computes again from a keyframe; and the way of a body, read in parts.
Result<Json> ask_slowly(HttpClient& client) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i < kContacts; ++i) {
    const auto contacts = timed(client, "contacts?log=0&step=" + std::to_string((i * 617 + 311) % (kSteps + 1)));
    if (!contacts.ok()) return contacts.error();
    seconds.push_back(contacts->second);
    if (const auto part = timed(client, "history?log=0&id=1&from=" + std::to_string(i * 60)); !part.ok())
      return part.error();
  }
  return Json{{"median", median(seconds)}, {"most", at_share(seconds, 1)}};
}

Result<Json> measure(ServerPlace& place, const std::string& side) {
  const std::string log = place.file("grid.tumble");
  if (Status ok = place.run({"record", "layered_grid", "--set", "grid.rows=" + side, "--set", "grid.cols=" + side,
                             "--steps", std::to_string(kSteps), "--quiet", "-o", log});
      !ok.ok()) {
    return ok.error();
  }
  const Clock::time_point start = Clock::now();
  if (Status ok = place.start_server({"view", log}); !ok.ok()) return ok.error();
  while (place.address().empty() && seconds_since(start) < kPatience) std::this_thread::sleep_for(kBetween / 20);
  Json json = {{"bodies", std::stoull(side) * std::stoull(side)}, {"steps", kSteps}, {"ready", seconds_since(start)}};
  HttpClient client(place.address(), kPatience);
  const Clock::time_point opened = Clock::now();
  for (const char* question : {"", "bodies?log=0", "frames?log=0&first=0&count=1&stride=1", "news?log=0"}) {
    if (const auto reply = timed(client, question); !reply.ok()) return reply.error();
  }
  json["open"] = seconds_since(opened);
  json["open_cpu"] = place.cpu();
  Result<Json> busy = seek(client, place);
  if (!busy.ok()) return busy.error();
  json["seek_while_reading"] = *std::move(busy);
  for (bool done = false; !done && seconds_since(start) < kPatience; std::this_thread::sleep_for(10 * kBetween)) {
    const auto reply = timed(client, "news?log=0");
    if (!reply.ok()) return reply.error();
    const Json news = Json::parse(reply->first, nullptr, false);
    if (news.is_discarded()) return cannot_finish("view: the server's news are no JSON");
    if (news["timeline_done"].get<bool>() && !json.contains("timeline")) json["timeline"] = seconds_since(start);
    done = news["timeline_done"].get<bool>() && news["contacts_done"].get<bool>();
  }
  json["contacts_begun"] = seconds_since(start);
  Result<Json> idle = seek(client, place);
  if (!idle.ok()) return idle.error();
  json["seek"] = *std::move(idle);
  Result<Json> contacts = ask_slowly(client);
  if (!contacts.ok()) return contacts.error();
  json["contacts"] = *std::move(contacts);
  json["megabytes"] = place.memory();
  json["cpu"] = place.cpu();
  return json;
}

std::string ms(const Json& seconds) { return short_number(seconds.get<double>() * 1e3) + " ms"; }

void print(const Json& row) {
  const auto met = [](double value, double most) { return value <= most ? "yes" : "no"; };
  std::cout << row["bodies"] << " bodies, " << row["steps"] << " steps\n";
  Table table({"figure", "measured", "wanted", "met"});
  table.add({"server ready", ms(row["ready"]), "", ""});
  table.add({"all that the page needs to open", ms(row["open"]), "1 s", met(row["open"], kOpenMost)});
  for (const char* name : {"seek", "seek_while_reading"}) {
    const Json& seek = row[name];
    table.add({std::string(name) == "seek" ? "a state after a seek" : "likewise while the timeline is read",
               ms(seek["median"]) + ", 9 of 10 in " + ms(seek["p90"]) + ", most " + ms(seek["most"]) + ", " +
                   ms(seek["cpu_each"]) + " of CPU",
               "100 ms", met(seek["median"], kSeekMost)});
  }
  table.add({"the contacts of a step, taken again",
             ms(row["contacts"]["median"]) + ", most " + ms(row["contacts"]["most"]), "", ""});
  table.add({"timeline complete", ms(row["timeline"]), "", ""});
  table.add({"memory of the server, at most", short_number(row["megabytes"]) + " MB", "500 MB",
             met(row["megabytes"], kMegabytesMost)});
  table.print();
}

}  // namespace

Result<Exit> bench_view(const BenchOptions& options) {
  if (!has_http_server())
    return cannot_finish("view: this program was built without libcpp-httplib-dev and serves no page");
  const Result<std::string> side = grid_side(options, kSide);
  if (!side.ok()) return side.error();
  ServerPlace place;
  const Result<Json> row = measure(place, *side);
  if (!row.ok()) return row.error();
  const Json results = {{"bench", "view"}, {"machine", machine_json()}, {"row", *row}};
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (options.json) return Exit::kSame;
  std::cout << machine_text(results["machine"]) << '\n';
  print(*row);
  return Exit::kSame;
}

}  // namespace tumble::tools
