// tumble diff: the first difference between two logs.
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/diff/difference_report.h"
#include "replay/log/hashes_only.h"
#include "src/base/text.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/compare/diff_output.h"
#include "tools/compare/log_groups.h"
#include "tools/compare/session_time.h"
#include "tools/compare/tolerance_arguments.h"
#include "tools/engine/zoom.h"
#include "tools/files/log_files.h"
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
  std::vector<std::string> more;
  std::vector<std::string> tolerances;
  std::optional<double> until;  // s
  std::optional<double> apart;  // m
  std::optional<std::uint64_t> step;
  std::string plot;
  bool shared = false;
  bool zoom = false;
  ZoomPrograms programs;
  bool brief = false;
  bool json = false;
};

// Explains the first difference, if there is one. Errors: a log whose states do not match its hashes.
Result<Difference> look_closer(replay::LogReader& a, replay::LogReader& b, const replay::DiffReport& report) {
  if (!report.first) return Difference();
  ProgressBar bar("looking closer");
  Result<replay::DifferenceReport> found = replay::report_difference(a, b, report, bar.progress());
  if (!found.ok()) return found.error();
  return Difference(*std::move(found));
}

Result<Exit> show_step(const DiffCommand& options, replay::LogReader& a, replay::LogReader& b) {
  const Result<bool> same = print_side_by_side(a, b, *options.step, options.json);
  if (!same.ok()) return same.error();
  return *same ? Exit::kSame : Exit::kDifference;
}

Status draw(const DiffCommand& options, const Difference& difference) {
  if (options.plot.empty()) return {};
  if (difference && difference->growth) {
    return draw_separation(options.plot, options.a + " and " + options.b, difference->growth->separation);
  }
  const std::string why = difference ? difference->growth_unknown : "";
  return cannot_finish("--plot: there is no separation to draw: " + (why.empty() ? "no step differs" : why));
}

DiffQuestion question_of(const DiffCommand& options, bool exact_bits) {
  return {options.a, options.b, exact_bits, options.brief, options.json, options.zoom, options.apart, ""};
}

/// --apart: when the two were first apart by more than that.
Result<std::optional<Parting>> parting_of(const DiffCommand& options, replay::LogReader& a, replay::LogReader& b,
                                          const replay::DiffReport& report, const Difference& difference,
                                          std::uint64_t last) {
  if (!options.apart) return std::optional<Parting>();
  if (replay::lack_states(a.header(), b.header())) {
    return bad_input("--apart: the distance of the two is not known: a log holds hashes and no places of bodies");
  }
  if (!report.first) return std::optional<Parting>();
  if (!difference || !difference->growth) {
    return cannot_finish("--apart: the distance of the two is not known: " +
                         (difference ? difference->growth_unknown : "the difference was not followed"));
  }
  return find_parting(a, difference->growth->separation, *options.apart, last);
}

Result<Exit> compare(const DiffCommand& options, replay::LogReader& a, replay::LogReader& b) {
  const Result<replay::Tolerances> tolerances = parse_tolerances(options.tolerances, a, b);
  if (!tolerances.ok()) return tolerances.error();
  ProgressBar bar("comparing");
  const replay::Reading reading = options.brief ? replay::Reading::kHashes : replay::Reading::kAll;
  std::uint64_t until = replay::kNoLimit;
  if (options.until) {
    const Result<std::uint64_t> step = step_until(a, b, *options.until);
    if (!step.ok()) return step.error();
    until = *step;
  }
  Result<replay::DiffReport> report = replay::diff_logs(a, b, *tolerances, bar.progress(), reading, until);
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
  replay::name_by_own_axes(a.header(), b.header(), *report, difference ? &*difference : nullptr);
  const std::string read = options.brief ? read_in_brief(*report) : read_of(a, b);
  std::optional<Zoom> zoom;
  if (options.zoom && report->first) {
    Result<Zoom> found = zoom_into(a, b, *report->first, options.programs);
    if (!found.ok()) return found.error();
    zoom = *std::move(found);
  }
  const std::uint64_t last = std::min(report->last_a, report->last_b);
  const Result<std::optional<Parting>> parting = parting_of(options, a, b, *report, difference, last);
  if (!parting.ok()) return parting.error();
  DiffQuestion question = question_of(options, tolerances->exact());
  if (options.shared) {
    question.excused = std::exchange(report->only_in, {}).text(sides_of(a, b).expected, sides_of(a, b).actual);
  }
  print_result(question, *report, difference, {sides_of(a, b), read, zoom, *parting});
  const bool all_measured = !difference || !difference->growth || !difference->growth->separation.bodies_from ||
                            *difference->growth->separation.bodies_from > last;
  if (options.apart && !options.json) print_parting(*parting, *options.apart, last, all_measured);
  if (Status ok = draw(options, difference); !ok.ok()) return ok.error();
  const bool is_same = options.apart ? !*parting && all_measured : report->identical();
  return is_same ? Exit::kSame : Exit::kDifference;
}

bool is_plain(const DiffCommand& options) {
  return options.tolerances.empty() && options.plot.empty() && !options.until && !options.apart && !options.step &&
         !options.zoom && !options.brief && !options.shared;
}

Result<Exit> diff(const DiffCommand& options) {
  if (!options.more.empty()) {
    if (!is_plain(options)) {
      return bad_input("of " + std::to_string(options.more.size() + 2) +
                       " logs every bit is compared: found an option that takes two logs, wanted none but --json");
    }
    std::vector<std::string> paths = {options.a, options.b};
    paths.insert(paths.end(), options.more.begin(), options.more.end());
    return diff_many(paths, options.json);
  }
  if (!options.plot.empty()) {
    if (Status ok = check_plot_path(options.plot); !ok.ok()) return ok.error();
    files::OutputGuard guard;
    for (const std::string& log : {options.a, options.b}) guard.keep(log, "a log that is compared");
    if (Status ok = claim_output(guard, "--plot", options.plot, files::kind_by_name(options.plot)); !ok.ok())
      return ok.error();
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

// The options of --zoom, which excludes --step.
void declare_zoom(Arguments& arguments, DiffCommand& options, const Argument& step) {
  const Argument zoom =
      arguments
          .flag("--zoom", options.zoom,
                "Also compute the first different step again in both builds, with probes, and name the first line of "
                "their sources with another value (docs/zoom.md)")
          .excludes(step);
  arguments
      .option("--engine-a", "ENGINE", options.programs.a,
              "The build that computed A, for --zoom: a folder with a tumble.toml, or a command line with {log}; of a "
              "log of ours a program tumble. If not given: the nearest tumble.toml, or this program")
      .needs(zoom);
  arguments.option("--engine-b", "ENGINE", options.programs.b, "The build that computed B, likewise").needs(zoom);
}

}  // namespace

Action declare_diff(Arguments& arguments) {
  auto options = std::make_shared<DiffCommand>();
  arguments.positional("A", options->a, "The log with the expected values").required();
  arguments.positional("B", options->b, "The log to compare with it").required();
  arguments.positionals("MORE", options->more,
                        "Further logs of runs that should agree: groups all of them and names the odd ones");
  const Argument tolerance =
      arguments
          .option(
              "--tolerance", "FIELD=V", options->tolerances,
              "Call states equal where each component of FIELD (position, velocity, spin: angular velocity), or "
              "the angle of FIELD orientation (rad), is at most V apart; states then decide, not hashes. FIELD may "
              "also be a channel, or a number of an input or a parameter (throw.velocity.y, dt, world.gravity). May be "
              "repeated")
          .offers({"position=", "orientation=", "velocity=", "spin="});
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
            "Only find the first difference, by the hashes: payloads are read only where hashes differ, and damage in "
            "the others is not seen")
      .excludes(step)
      .excludes(plot);
  constexpr double kTimeMax = 1e9, kLengthMax = 1e6;
  const Argument until = arguments.positive("--until", "T", options->until, kTimeMax,
                                            "Compare only the steps that end within T seconds of the start");
  const Argument apart = arguments.positive(
      "--apart", "D", options->apart, kLengthMax,
      "Ask when a body's centre is first more than D m from its place in the other log: status 1 if that happens, "
      "whatever bits differ");
  until.excludes(step);
  apart.excludes(step);
  arguments
      .flag("--shared", options->shared,
            "Judge only what both logs have: a channel that one log alone has is named, and no difference")
      .excludes(step);
  declare_zoom(arguments, *options, step);
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
      "  tumble diff before.tumble after.tumble --apart 0.01 --until 2\n"
      "  tumble diff peer_1.tumble peer_2.tumble peer_3.tumble peer_4.tumble\n"
      "  tumble diff before.tumble after.tumble --zoom --engine-a old/checkout --engine-b .\n"
      "  tumble diff before.tumble after.tumble --tolerance position=1e-6 --tolerance velocity=1e-4 --json");
  return [options] { return diff(*options); };
}

}  // namespace tumble::tools
