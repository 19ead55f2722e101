// tumble diff: the first difference between two logs.
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "replay/diff/difference_report.h"
#include "src/base/text.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/numbers.h"
#include "tools/files/log_files.h"
#include "tools/output/axes_output.h"
#include "tools/output/blame_output.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/gnuplot.h"
#include "tools/output/progress.h"
#include "tools/output/separation_plot.h"
#include "tools/output/side_by_side.h"
#include "tools/output/text.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

struct DiffCommand {
  std::string a;
  std::string b;
  std::vector<std::string> tolerances;
  std::optional<std::uint64_t> step;
  std::string plot;
  bool brief = false;
  bool json = false;
};

Result<replay::Tolerances> parse_tolerances(const std::vector<std::string>& arguments,
                                            const std::vector<replay::Channel>& channels) {
  replay::Tolerances tolerances;
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : parse_number(argument.substr(equals + 1));
    if (!value) {
      return bad_input("--tolerance: found " + in_quotes(argument) +
                       ", wanted FIELD=V with a number V, as in position=1e-9");
    }
    const Status set = replay::set_tolerance(tolerances, argument.substr(0, equals), *value, channels);
    if (!set.ok()) return bad_input("--tolerance " + printable(argument) + ": " + set.error().message);
  }
  return tolerances;
}

// If one log is longer and equal so far, the first difference is the step that only this log has.
std::optional<replay::Divergence> first_of(const replay::DiffReport& report) {
  if (report.first || report.identical()) return report.first;
  replay::Divergence end;
  end.step = std::min(report.last_a, report.last_b) + 1;
  end.phase = "step";
  end.field = "steps";
  end.expected = report.last_a;
  end.actual = report.last_b;
  return end;
}

constexpr std::size_t kHeadersShown = 20;

/// The first word of the verdict, and what was read for it.
std::string same_text(const DiffCommand& options, bool exact_bits, std::uint64_t zeros, const std::string& steps) {
  const std::string words = exact_bits ? "identical: " + steps : "same within tolerances: " + steps;
  if (options.brief) return words + ", by hashes; payloads not read";
  if (zeros > 0) return words + ", but for the sign of " + count_text(zeros, "zero");
  return words + (exact_bits ? ", every bit" : "");
}

void print_text(const DiffCommand& options, const replay::DiffReport& report, bool exact_bits) {
  for (std::size_t i = 0; i < std::min(kHeadersShown, report.headers.size()); ++i) {
    std::cout << "header: " << printable(describe(report.headers[i])) << '\n';
  }
  if (report.headers.size() > kHeadersShown) {
    std::cout << "header: " << report.headers.size() - kHeadersShown << " more differences (all with --json)\n";
  }
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  if (report.from > 0) std::cout << "compared from step " << report.from << " on, which both logs have\n";
  const std::string steps = count_text(report.steps, "step");
  if (report.identical()) {
    std::cout << same_text(options, exact_bits, report.zeros, steps) << '\n';
  } else if (report.first) {
    std::cout << "different from step " << report.first->step << " on\n";
  } else {
    std::cout << "different in length: the first ends with step " << report.last_a << ", the second with step "
              << report.last_b << "; the " << steps << " of both are the same\n";
  }
  if (const std::string though = report.though(); !though.empty()) std::cout << "  " << though << '\n';
  if (!report.first) print_scope(report.scope);
}

using Difference = std::optional<replay::DifferenceReport>;

// Explains the first difference, if there is one. Errors: a log whose states do not match its hashes.
Result<Difference> look_closer(replay::LogReader& a, replay::LogReader& b, const replay::DiffReport& report) {
  if (!report.first) return Difference();
  ProgressBar bar("looking closer");
  Result<replay::DifferenceReport> found = replay::report_difference(a, b, report, bar.progress());
  if (!found.ok()) return found.error();
  return Difference(*std::move(found));
}

// Names the fields by the table's axes where both logs have the same. Lengths stay in m, as --tolerance takes them.
void name_by_table(const replay::LogHeader& a, const replay::LogHeader& b, replay::DiffReport& report,
                   Difference& difference) {
  const replay::EngineAxes axes = common_axes(a, b);
  if (axes.ours()) return;
  report.notes.push_back("fields are named by the axes of the tables: " + to_string(axes));
  if (report.first) report.first = in_axes(axes, *report.first);
  if (difference) difference = in_axes(axes, *std::move(difference));
}

/// Adds the names of body and pair; a body that the first log does not name may have one in the second.
void name_bodies(replay::LogReader& a, replay::LogReader& b, replay::Divergence& found) {
  const auto name = [&](sim::BodyId id) {
    const std::string in_a = a.bodies().name(id);
    return in_a.empty() ? b.bodies().name(id) : in_a;
  };
  if (found.pair) {
    const std::string one = name(found.pair->first), other = name(found.pair->second);
    if (!one.empty() || !other.empty()) found.names = one + " and " + other;
  } else if (found.body) {
    found.names = name(*found.body);
  }
}

Result<Exit> show_step(const DiffCommand& options, replay::LogReader& a, replay::LogReader& b) {
  const Result<bool> same = print_side_by_side(a, b, *options.step, options.json);
  if (!same.ok()) return same.error();
  return *same ? Exit::kSame : Exit::kDifference;
}

Json headers_json(const std::vector<replay::HeaderDifference>& headers) {
  Json rows = Json::array();
  for (const replay::HeaderDifference& difference : headers) {
    rows.push_back({{"key", difference.key},
                    {"expected", value_json(difference.a)},
                    {"actual", value_json(difference.b)},
                    {"acts", difference.acts},
                    {"excused", difference.excused}});
  }
  return rows;
}

// The command that explains the first value that differs, in a log whose step this build repeats; empty where there is
// none.
std::string next_command(const DiffCommand& options, const Difference& difference) {
  if (!difference || !difference->effect) return "";
  const replay::DivergenceLocation& location = difference->location;
  if (!location.as_a && !location.as_b) return "";
  return blame_command(location.as_b ? options.b : options.a, *difference->effect);
}

void print_result(const DiffCommand& options, const std::string& read, const replay::DiffReport& report,
                  const Difference& difference, bool exact_bits) {
  if (options.json) {
    Json json = comparison_json(report.identical(), report.steps, first_of(report));
    json["read"] = read;
    add_scope(report.scope, json);
    json["zeros_of_other_sign"] = report.zeros;
    json["notes"] = report.notes;
    json["headers"] = Json::array();
    for (const replay::HeaderDifference& header : report.headers) json["headers"].push_back(describe(header));
    json["header_differences"] = headers_json(report.headers);
    if (difference) add_difference(*difference, Compared::kTwoLogs, json);
    const std::string next = next_command(options, difference);
    json["next"] = next.empty() ? Json(nullptr) : Json(next);
    print_json(json);
    return;
  }
  print_text(options, report, exact_bits);
  const Sides sides = sides_of(options.a, options.b);
  if (difference) {
    print_difference(*difference, Compared::kTwoLogs, sides);
    const std::string next = next_command(options, difference);
    if (!next.empty()) std::cout << "to find the cause of that value: " << printable(next) << '\n';
  } else if (report.first) {
    std::cout << "cause   " << printable(replay::cause_of(report, *report.first)) << '\n';
    print_divergence(*report.first, sides);
    if (options.brief) std::cout << "  read        " << read << ", so damage in them is not seen\n";
  }
}

Status draw(const DiffCommand& options, const Difference& difference) {
  if (options.plot.empty()) return {};
  if (difference && difference->growth) {
    return draw_separation(options.plot, options.a + " and " + options.b, difference->growth->separation);
  }
  const std::string why = difference ? difference->growth_unknown : "";
  return cannot_finish("--plot: there is no separation to draw: " + (why.empty() ? "no step differs" : why));
}

Result<Exit> compare(const DiffCommand& options, replay::LogReader& a, replay::LogReader& b) {
  std::vector<replay::Channel> channels = a.header().declared.channels;
  for (const replay::Channel& channel : b.header().declared.channels) {
    if (a.header().declared.find(channel.name) == a.header().declared.channels.size()) channels.push_back(channel);
  }
  const Result<replay::Tolerances> tolerances = parse_tolerances(options.tolerances, channels);
  if (!tolerances.ok()) return tolerances.error();
  ProgressBar bar("comparing");
  const replay::Reading reading = options.brief ? replay::Reading::kHashes : replay::Reading::kAll;
  Result<replay::DiffReport> report = replay::diff_logs(a, b, *tolerances, bar.progress(), reading);
  bar.finish();
  if (!report.ok()) return report.error();
  Difference difference;
  if (!options.brief && !process::InterruptGuard::interrupted()) {
    Result<Difference> closer = look_closer(a, b, *report);
    if (!closer.ok()) return closer.error();
    difference = *std::move(closer);
    if (difference) report->first = difference->first;
  }
  if (process::InterruptGuard::interrupted()) return cannot_finish("interrupted");
  if (report->first) name_bodies(a, b, *report->first);
  if (difference) name_bodies(a, b, difference->first);
  if (difference && difference->effect) name_bodies(a, b, *difference->effect);
  name_by_table(a.header(), b.header(), *report, difference);
  const std::string read = options.brief ? "hashes; payloads not read" : read_of(a, b);
  print_result(options, read, *report, difference, tolerances->exact());
  if (Status ok = draw(options, difference); !ok.ok()) return ok.error();
  return report->identical() ? Exit::kSame : Exit::kDifference;
}

Result<Exit> diff(const DiffCommand& options) {
  if (!options.plot.empty()) {
    if (Status ok = check_plot_path(options.plot); !ok.ok()) return ok.error();
    files::OutputGuard guard;
    for (const std::string& log : {options.a, options.b}) guard.keep(log, "a log that is compared");
    if (Status ok = claim_output(guard, "--plot", options.plot); !ok.ok()) return ok.error();
  }
  Result<replay::LogReader> a = open_log(options.a);
  if (!a.ok()) return a.error();
  Result<replay::LogReader> b = open_log(options.b);
  if (!b.ok()) return b.error();
  const process::InterruptGuard guard;
  Result<Exit> verdict = options.step ? show_step(options, *a, *b) : compare(options, *a, *b);
  if (!verdict.ok()) return verdict;
  return judge("diff", *b, judge("diff", *a, *verdict));
}

}  // namespace

Action declare_diff(Arguments& arguments) {
  auto options = std::make_shared<DiffCommand>();
  arguments.positional("A", options->a, "The log with the expected values").required();
  arguments.positional("B", options->b, "The log to compare with it").required();
  const Argument tolerance = arguments.option(
      "--tolerance", "FIELD=V", options->tolerances,
      "Call states equal where each component of FIELD (position, velocity, spin: angular velocity), or "
      "the angle of FIELD orientation (rad), is at most V apart; states then decide, not hashes. FIELD may "
      "also be a channel, or a number of an input or a parameter (throw.velocity.y, dt, world.gravity). May be "
      "repeated");
  const Argument step =
      arguments
          .whole(
              "--step", "K", options->step, 0, sim::kStepsMax,
              "Show step K of both side by side, phase by phase, and the bodies that differ, in every bit. Reads the "
              "chunks with this step, not the rest of the logs")
          .excludes(tolerance);
  const Argument plot =
      arguments
          .option("--plot", "FILE.svg|png", options->plot,
                  "Also draw the separation of the two over the steps, on a logarithmic scale, with gnuplot")
          .excludes(step);
  arguments
      .flag("--brief", options->brief,
            "Only find the first difference, by the hashes: payloads are not read, damage in them is not seen")
      .excludes(step)
      .excludes(plot);
  arguments.json(options->json);
  arguments.footer(
      "Exit status: 0 the same, 1 a difference, 3 a log is torn (the intact part is compared), damaged, or broken:\n"
      "its states do not match its hashes. Both logs are read from end to end first; --brief reads hashes, and --step "
      "K\n"
      "the chunks with step K.\n\n"
      "Examples:\n"
      "  tumble diff before.tumble after.tumble\n"
      "  tumble diff before.tumble after.tumble --step 120\n"
      "  tumble diff before.tumble after.tumble --plot separation.svg\n"
      "  tumble diff before.tumble after.tumble --tolerance position=1e-6 --tolerance velocity=1e-4 --json");
  return [options] { return diff(*options); };
}

}  // namespace tumble::tools
