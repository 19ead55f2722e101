// tumble diff: the first difference between two logs.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "replay/compare.h"
#include "replay/log_reader.h"
#include "src/scenes/problem.h"
#include "tools/arguments.h"
#include "tools/command.h"
#include "tools/divergence_output.h"
#include "tools/interrupt.h"
#include "tools/log_files.h"
#include "tools/progress.h"
#include "tools/text.h"

namespace tumble::tools {
namespace {

struct Options {
  std::string a;
  std::string b;
  std::vector<std::string> tolerances;
  bool json = false;
};

Result<replay::Tolerances> parse_tolerances(const std::vector<std::string>& arguments) {
  replay::Tolerances tolerances;
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : parse_number(argument.substr(equals + 1));
    if (!value) {
      return bad_input("--tolerance: found " + scenes::quoted(argument) +
                       ", wanted FIELD=V with a number V, as in position=1e-9");
    }
    const Status set = replay::set_tolerance(tolerances, argument.substr(0, equals), *value);
    if (!set.ok()) return bad_input("--tolerance " + argument + ": " + set.error().message);
  }
  return tolerances;
}

// Where one log goes on and the other does not, the first difference is the step that only one of them has.
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
    print_divergence(*report.first);
  } else {
    std::cout << "different in length: the first ends with step " << report.last_a << ", the second with step "
              << report.last_b << "; the " << steps << " of both are the same\n";
  }
}

Result<Exit> diff(const Options& options) {
  const Result<replay::Tolerances> tolerances = parse_tolerances(options.tolerances);
  if (!tolerances.ok()) return tolerances.error();
  Result<replay::LogReader> a = open_log(options.a);
  if (!a.ok()) return a.error();
  Result<replay::LogReader> b = open_log(options.b);
  if (!b.ok()) return b.error();
  const InterruptGuard guard;
  ProgressBar bar("comparing");
  const Result<replay::DiffReport> report =
      replay::diff_logs(*a, *b, *tolerances, [&](std::uint64_t done, std::uint64_t total) {
        bar.show(done, total);
        return !InterruptGuard::interrupted();
      });
  bar.finish();
  if (!report.ok()) return report.error();
  if (InterruptGuard::interrupted()) return cannot_finish("interrupted");
  if (options.json) {
    print_json(comparison_json(report->identical(), report->steps, first_of(*report)));
  } else {
    print_text(*report, tolerances->exact());
  }
  const Exit verdict = report->identical() ? Exit::kSame : Exit::kDifference;
  return judge("diff", *b, judge("diff", *a, verdict));
}

}  // namespace

Action declare_diff(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("A", options->a, "The log with the expected values")->required()->type_name("");
  app.add_option("B", options->b, "The log to compare with it")->required()->type_name("");
  app.add_option(
         "--tolerance", options->tolerances,
         "Call states the same where each component of FIELD (position, orientation, velocity, spin) is at most "
         "V apart; then states decide and hashes do not. May be repeated")
      ->type_name("FIELD=V")
      ->allow_extra_args(false);
  add_json(app, options->json);
  app.footer(
      "Exit status: 0 the same, 1 a difference, 3 a log is damaged or torn (the whole parts are compared).\n\n"
      "Examples:\n"
      "  tumble diff before.tumble after.tumble\n"
      "  tumble diff before.tumble after.tumble --tolerance position=1e-6 --tolerance velocity=1e-4 --json");
  return [options] { return diff(*options); };
}

}  // namespace tumble::tools
