// tumble view: a session on one page, to send or served from this machine.
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/base/text.h"
#include "src/files/output_file.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/measure_arguments.h"
#include "tools/files/log_files.h"
#include "tools/output/progress.h"
#include "tools/view/case_bounds.h"
#include "tools/view/difference_data.h"
#include "tools/view/http_server.h"
#include "tools/view/packed_session.h"
#include "tools/view/session_page.h"
#include "tools/view/view_json.h"

namespace tumble::tools {
namespace {

constexpr double kMegabytes = 3;
constexpr double kMegabytesMax = 200;
constexpr std::uint64_t kPortMax = 65535;

struct ViewCommand {
  std::string log;
  std::string other;
  std::string output;
  std::vector<std::string> require;
  std::string rules;
  std::optional<double> megabytes;
  std::optional<std::uint64_t> port;
};

using Logs = std::vector<replay::LogReader>;

Status claim_page(const ViewCommand& options) {
  files::OutputGuard guard;
  guard.keep(options.log, "a log that is shown");
  if (!options.other.empty()) guard.keep(options.other, "a log that is shown");
  if (!options.rules.empty()) guard.keep(options.rules, "the bounds of a case");
  return claim_output(guard, "-o", options.output, files::FileKind::kPage);
}

// The bytes of the page that its data may take: base 64 makes four of three.
Result<std::uint64_t> data_bytes(const ViewCommand& options, std::size_t other_bytes) {
  constexpr std::uint64_t kReserve = 16 << 10;  // heads and elements around the data
  const double megabytes = options.megabytes.value_or(kMegabytes);
  const auto wanted = static_cast<std::uint64_t>(1e6 * megabytes);
  const std::uint64_t taken = empty_page_bytes() + 4 * other_bytes / 3 + kReserve;
  if (wanted > taken) return (wanted - taken) / 4 * 3;
  return bad_input("--megabytes: found " + number_text(megabytes) + ", wanted more than " +
                   significant(static_cast<double>(taken) / 1e6, 3) + ", which the page takes without any state");
}

std::string thin_text(const Json& head) {
  const Json& thin = head["thin"];
  std::string text = printable(head["path"].get<std::string>()) + ": ";
  const std::uint64_t every = thin["every"], frames = thin["steps"].size();
  const std::uint64_t all = head["last"].get<std::uint64_t>() - head["first"].get<std::uint64_t>() + 1;
  text += every == 1 ? "every state, " + std::to_string(frames) + " in all"
                     : std::to_string(frames) + " of " + std::to_string(all) + " states";
  text += ", to 0.1 mm; contacts of " + count_text(thin["contact_steps"].get<std::uint64_t>(), "state");
  return text;
}

using Bounds = std::vector<replay::ViewedBound>;

Result<Bounds> parse_bounds(const ViewCommand& options, replay::LogReader& log) {
  Bounds bounds;
  for (const std::string& text : options.require) {
    Result<replay::MetricBound> bound = replay::parse_metric_bound(text);
    if (bound.ok() && bound->metric->needs_other_session()) {
      bound = bad_input("found " + in_quotes(text) + ", wanted a metric of this session alone");
    }
    if (!bound.ok()) return bad_input("--require: " + bound.error().message);
    bounds.push_back({*std::move(bound)});
  }
  if (options.rules.empty()) return bounds;
  Result<CaseBounds> of_case = bounds_of_case(options.rules, log.header().axes(), log.bodies());
  if (!of_case.ok()) return of_case.error();
  for (const std::string& note : of_case->notes) std::cerr << "tumble view: " << note << '\n';
  for (replay::ViewedBound& bound : of_case->bounds) bounds.push_back(std::move(bound));
  return bounds;
}

Result<Exit> write_page(const ViewCommand& options, Logs& logs, const Bounds& bounds) {
  if (Status ok = claim_page(options); !ok.ok()) return ok.error();
  const process::InterruptGuard guard;
  SessionPage page;
  page.head = {{"mode", "sent"}, {"bounds", Json::array()}, {"logs", Json::array()}};
  for (const replay::ViewedBound& bound : bounds) page.head["bounds"].push_back(printable(bound.bound.text));
  PackOptions pack;
  pack.bounds = bounds;
  if (logs.size() == 2) {
    ProgressBar bar("comparing");
    Result<Json> difference = difference_data(logs[0], logs[1], bar.progress());
    bar.finish();
    if (!difference.ok()) return difference.error();
    if (const Json& first = (*difference)["first"]; !first.is_null()) {
      const std::uint64_t step = first["step"];
      pack.keep = {step > 0 ? step - 1 : 0, step};
    }
    page.difference = deflated(dumped(*difference));
  }
  const Result<std::uint64_t> bytes = data_bytes(options, page.difference.size());
  if (!bytes.ok()) return bytes.error();
  pack.bytes_max = *bytes / logs.size();
  for (replay::LogReader& log : logs) {
    ProgressBar bar("reading");
    Result<PackedSession> packed = pack_session(log, pack, bar.progress());
    bar.finish();
    if (!packed.ok()) return packed.error();
    page.head["logs"].push_back(packed->head);
    page.packed.push_back(*std::move(packed));
  }
  const std::string html = page.html();
  if (Status ok = files::write_whole_file(options.output, html); !ok.ok()) return ok.error();
  std::cout << printable(options.output) << ": " << bytes_text(html.size()) << ", opens in any browser\n";
  if (static_cast<double>(html.size()) > 1e6 * options.megabytes.value_or(kMegabytes)) {
    std::cout << "  more than --megabytes allows: its bodies, timeline and fewest states take as much\n";
  }
  for (const Json& head : page.head["logs"]) std::cout << "  " << thin_text(head) << '\n';
  Exit exit = Exit::kSame;
  for (const PackedSession& packed : page.packed) {
    if (packed.unread == 0) continue;
    std::cerr << "tumble view: " << count_text(packed.unread, "step")
              << " could not be read, the first: " << printable(packed.why_unread) << '\n';
    exit = Exit::kDamaged;
  }
  return exit;
}

Result<Exit> serve(const ViewCommand& options, Logs logs, const Bounds& bounds) {
  if (!has_http_server()) {
    return cannot_finish(
        "this program was built without libcpp-httplib-dev and cannot serve the page; write it with -o FILE.html");
  }
  const process::InterruptGuard guard;
  SessionService service(std::move(logs), bounds);
  const Status served = serve_http(service, options.port, page_policy(true), [](const std::string& address) {
    std::cout << address << "\nOpen this address in a browser of this machine. Ctrl-C ends it." << std::endl;
  });
  if (!served.ok()) return served.error();
  return Exit::kSame;
}

Result<Exit> view(const ViewCommand& options) {
  Logs logs;
  for (const std::string& path : {options.log, options.other}) {
    if (path.empty()) continue;
    // Served, a log may be so young that it has no chunk yet.
    Result<replay::LogReader> log = options.output.empty() ? replay::LogReader::open(path) : open_log(path);
    if (!log.ok()) return log.error();
    if (Status ok = wants_values(*log); !ok.ok()) return ok.error();
    logs.push_back(*std::move(log));
  }
  const Result<Bounds> bounds = parse_bounds(options, logs.front());
  if (!bounds.ok()) return bounds.error();
  if (options.output.empty()) return serve(options, std::move(logs), *bounds);
  Result<Exit> verdict = write_page(options, logs, *bounds);
  if (!verdict.ok()) return verdict;
  for (const replay::LogReader& log : logs) verdict = judge("view", log, *verdict);
  return verdict;
}

}  // namespace

Action declare_view(Arguments& arguments) {
  auto options = std::make_shared<ViewCommand>();
  arguments.positional("LOG", options->log, "The log to look at").required();
  arguments.positional("OTHER", options->other, "A second log, shown beside the first or as its ghost, and compared");
  const Argument output = arguments.option("-o,--output", "FILE.html", options->output,
                                           "Write one page that needs no network, instead of serving one");
  arguments
      .positive("--megabytes", "MB", options->megabytes, kMegabytesMax,
                "The size that the page of -o must keep to (3 unless said); states are left out evenly until it fits")
      .needs(output);
  arguments.whole("--port", "N", options->port, 1, kPortMax, "Serve on this port of 127.0.0.1, not on any free one")
      .excludes(output);
  arguments
      .option("--require", "EXPR", options->require,
              "Show in the timeline where a bound on a metric breaks, as in 'lateral_max<=0'. May be repeated")
      .offers(metric_words());
  arguments.option("--bounds", "FILE", options->rules,
                   "Likewise the bounds of a case: its metrics.toml, as golden/cases/NAME/metrics.toml");
  arguments.footer(
      "Without -o the page is served to browsers of this machine, under an address with a secret, until Ctrl-C.\n"
      "It shows every state; a log that is still being recorded is followed. The page of -o is thinned and says so.\n\n"
      "Exit status: 0 done, 3 a log is torn or damaged (its intact part is in the page).\n\n"
      "Examples:\n"
      "  tumble view brick_wall.tumble\n"
      "  tumble view brick_wall.tumble -o session.html\n"
      "  tumble view bounce.tumble --bounds golden/cases/bounce/metrics.toml\n"
      "  tumble view before.tumble after.tumble -o both.html --megabytes 8");
  return [options] { return view(*options); };
}

}  // namespace tumble::tools
