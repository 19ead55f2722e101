// tumble diff: the first difference between two logs.
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "replay/diff/difference_report.h"
#include "replay/diff/separation.h"
#include "src/base/text.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/numbers.h"
#include "tools/files/log_files.h"
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

struct Options {
  std::string a;
  std::string b;
  std::vector<std::string> tolerances;
  std::optional<std::uint64_t> step;
  std::string plot;
  bool brief = false;
  bool json = false;
};

Result<replay::Tolerances> parse_tolerances(const std::vector<std::string>& arguments) {
  replay::Tolerances tolerances;
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : parse_number(argument.substr(equals + 1));
    if (!value) {
      return bad_input("--tolerance: found " + in_quotes(argument) +
                       ", wanted FIELD=V with a number V, as in position=1e-9");
    }
    const Status set = replay::set_tolerance(tolerances, argument.substr(0, equals), *value);
    if (!set.ok()) return bad_input("--tolerance " + argument + ": " + set.error().message);
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

void print_text(const replay::DiffReport& report, bool exact_bits) {
  for (const std::string& line : report.headers) std::cout << "header: " << printable(line) << '\n';
  if (report.from > 0) std::cout << "compared from step " << report.from << " on, which both logs have\n";
  const std::string steps = count_text(report.steps, "step");
  if (report.identical()) {
    std::cout << (exact_bits ? "identical: " + steps + ", every bit\n" : "same within tolerances: " + steps + '\n');
  } else if (report.first) {
    std::cout << "different from step " << report.first->step << " on\n";
  } else {
    std::cout << "different in length: the first ends with step " << report.last_a << ", the second with step "
              << report.last_b << "; the " << steps << " of both are the same\n";
  }
}

replay::Progress progress_on(ProgressBar& bar) {
  return [&bar](std::uint64_t done, std::uint64_t total) {
    bar.show(done, total);
    return !process::InterruptGuard::interrupted();
  };
}

using Difference = std::optional<replay::DifferenceReport>;

// Explains the first difference. Where there is none, compares all states of the two logs, whose hashes are the same.
// Errors: a log whose states do not match its hashes.
Result<Difference> look_closer(replay::LogReader& a, replay::LogReader& b, const replay::DiffReport& report,
                               bool exact_bits) {
  ProgressBar bar("looking closer");
  const std::uint64_t last = std::min(report.last_a, report.last_b);
  if (!report.first) {
    if (!exact_bits) return Difference();
    if (Status ok = replay::confirm_states(a, b, report.from, last, progress_on(bar)); !ok.ok()) return ok.error();
    return Difference();
  }
  Result<replay::DifferenceReport> found = replay::report_difference(a, b, *report.first, progress_on(bar));
  if (!found.ok()) return found.error();
  return Difference(*std::move(found));
}

Result<Exit> show_step(const Options& options, replay::LogReader& a, replay::LogReader& b) {
  const Result<bool> same = print_side_by_side(a, b, *options.step, options.json);
  if (!same.ok()) return same.error();
  return *same ? Exit::kSame : Exit::kDifference;
}

Status draw(const Options& options, const Difference& difference) {
  if (options.plot.empty()) return {};
  if (difference && difference->growth) {
    return draw_separation(options.plot, options.a + " and " + options.b, difference->growth->separation);
  }
  const std::string why = difference ? difference->growth_unknown : "";
  return cannot_finish("--plot: there is no separation to draw: " + (why.empty() ? "no step differs" : why));
}

Result<Exit> compare(const Options& options, replay::LogReader& a, replay::LogReader& b) {
  const Result<replay::Tolerances> tolerances = parse_tolerances(options.tolerances);
  if (!tolerances.ok()) return tolerances.error();
  ProgressBar bar("comparing");
  Result<replay::DiffReport> report = replay::diff_logs(a, b, *tolerances, progress_on(bar));
  bar.finish();
  if (!report.ok()) return report.error();
  Difference difference;
  if (!options.brief && !process::InterruptGuard::interrupted()) {
    Result<Difference> closer = look_closer(a, b, *report, tolerances->exact());
    if (!closer.ok()) return closer.error();
    difference = *std::move(closer);
    if (difference) report->first = difference->first;
  }
  if (process::InterruptGuard::interrupted()) return cannot_finish("interrupted");
  if (options.json) {
    Json json = comparison_json(report->identical(), report->steps, first_of(*report));
    json["headers"] = report->headers;
    if (difference) add_difference(*difference, Compared::kTwoLogs, json);
    print_json(json);
  } else {
    print_text(*report, tolerances->exact());
    if (difference) {
      print_difference(*difference, Compared::kTwoLogs);
    } else if (report->first) {
      print_divergence(*report->first);
    }
  }
  if (Status ok = draw(options, difference); !ok.ok()) return ok.error();
  return report->identical() ? Exit::kSame : Exit::kDifference;
}

Result<Exit> diff(const Options& options) {
  if (!options.plot.empty()) {
    if (Status ok = check_plot_path(options.plot); !ok.ok()) return ok.error();
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
  auto options = std::make_shared<Options>();
  arguments.positional("A", options->a, "The log with the expected values").required();
  arguments.positional("B", options->b, "The log to compare with it").required();
  arguments.option("--tolerance", "FIELD=V", options->tolerances,
                   "Call states equal where each component of FIELD (position, orientation, velocity, spin: angular "
                   "velocity) is at most V apart; states then decide, not hashes. May be repeated");
  const Argument step = arguments.whole("--step", "K", options->step, 0, sim::kStepsMax,
                                        "Show step K of both side by side, phase by phase, and the bodies that differ");
  const Argument plot =
      arguments
          .option("--plot", "FILE.svg|png", options->plot,
                  "Also draw the separation of the two over the steps, on a logarithmic scale, with gnuplot")
          .excludes(step);
  arguments.flag("--brief", options->brief, "Only find the first difference, by the hashes; do not follow its growth")
      .excludes(step)
      .excludes(plot);
  arguments.json(options->json);
  arguments.footer(
      "Exit status: 0 the same, 1 a difference, 3 a log is damaged or torn (the intact parts are compared),\n"
      "or broken: its states do not match its hashes.\n\n"
      "Examples:\n"
      "  tumble diff before.tumble after.tumble\n"
      "  tumble diff before.tumble after.tumble --step 120\n"
      "  tumble diff before.tumble after.tumble --plot separation.svg\n"
      "  tumble diff before.tumble after.tumble --tolerance position=1e-6 --tolerance velocity=1e-4 --json");
  return [options] { return diff(*options); };
}

}  // namespace tumble::tools
