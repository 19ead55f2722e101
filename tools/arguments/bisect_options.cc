#include "tools/arguments/bisect_options.h"

#include <utility>

namespace tumble::tools {
namespace {

/// Options that say how commits are asked, and those that are given.
std::vector<std::string> given_of_commits(const BisectArguments& options) {
  const std::pair<const char*, bool> all[] = {{"--metric", !options.metric.empty()},
                                              {"--bodies", options.measure.bodies != "all"},
                                              {"--axis", !options.measure.axis.empty()},
                                              {"--from-step", options.measure.from_step.has_value()},
                                              {"--case", !options.case_name.empty()},
                                              {"--image", options.image},
                                              {"--repo", !options.repository.empty()},
                                              {"--first-parent", options.first_parent},
                                              {"--build", !options.build.empty()},
                                              {"--program", !options.program.empty()},
                                              {"--run", !options.run.empty()},
                                              {"--scene", !options.scene.empty()},
                                              {"--timeout", options.timeout.has_value()},
                                              {"--work", !options.work.empty()},
                                              {"--jobs", options.jobs.has_value()},
                                              {"--asks", options.asks.has_value()},
                                              {"--cache", !options.cache.empty()},
                                              {"--resume", options.resume},
                                              {"--keep", options.keep}};
  std::vector<std::string> given;
  for (const auto& [name, is_given] : all) {
    if (is_given) given.emplace_back(name);
  }
  return given;
}

/// An option that would be passed over changes nothing, which its user does not know.
Status check_passed_over(const BisectArguments& options) {
  const MeasureArguments& measure = options.measure;
  const bool measures = measure.bodies != "all" || !measure.axis.empty() || measure.from_step;
  if (measures && options.metric.empty()) {
    return bad_input("--bodies, --axis, --from-step: found without --metric, wanted the bound that they are about");
  }
  if (options.shared) return bad_input("--shared: found with one log, wanted two logs, of which one may have more");
  return {};
}

void declare_question(Arguments& arguments, BisectArguments& options) {
  arguments
      .option("--metric", "EXPR", options.metric,
              "Ask whether the session, recorded anew by each revision, is within a bound, as in 'lateral_max<=0'")
      .offers(metric_words());
  add_measure(arguments, options.measure);
  arguments.option("--case", "NAME", options.case_name,
                   "Ask whether each revision's own check of this golden case passes");
  arguments.flag("--image", options.image, "With --case: ask for the image verdict alone");
}

void declare_building(Arguments& arguments, BisectArguments& options) {
  arguments.option("--repo", "DIR", options.repository, "A folder in the clone; the current one if not given");
  arguments.flag("--first-parent", options.first_parent, "Follow first parents only, to find a merge");
  arguments.option(
      "--build", "COMMAND", options.build,
      "A command that builds a revision, run in its folder; may be repeated. If not given: none with --run, else the "
      "release preset's build of tumble; of another engine's session, that of tumble.toml");
  arguments.option(
      "--program", "PATH", options.program,
      "The program that the build makes, a path from that folder; build/release/tools/tumble if not given");
  arguments.option(
      "--run", "COMMAND", options.run,
      "Instead of the program and of tumble.toml: a command of any engine that makes the log {log} of the scene "
      "{scene} and the inputs {inputs}");
  arguments.option("--scene", "FILE", options.scene,
                   "Another engine's {scene}: this file for every revision, in place of each revision's own");
  constexpr double kTimeoutMax = 1e6;
  arguments.positive("--timeout", "S", options.timeout, kTimeoutMax, "Skip a revision whose program takes longer");
  arguments.option("--work", "DIR", options.work,
                   "Work in this folder; one under the folder for temporary files if not given");
  arguments.whole("--jobs", "N", options.jobs, 1, 64,
                  "Revisions built and asked at once; one for every eight processors if not given, at most four");
  arguments.whole("--asks", "N", options.asks, 1, 100,
                  "Ask each revision N times, and more often if its answers differ; 2 if not given");
  const Argument cache = arguments.option("--cache", "DIR", options.cache, "Keep the built programs in this folder");
  arguments.positive("--cache-size", "GB", options.cache_gb, 1e6, "Its bound; 5 if not given").needs(cache);
  arguments.flag("--resume", options.resume, "Continue an interrupted bisection: its arguments and --resume");
  arguments.flag("--keep", options.keep, "Keep the folder with the clone, the last build and the sessions");
}

}  // namespace

Status check_for_logs(const BisectArguments& options) {
  const std::vector<std::string> given = given_of_commits(options);
  if (given.empty()) return {};
  return bad_input(given.front() + ": found with two logs, which are compared whole; wanted with --good and --bad or " +
                   "--auto, and one log");
}

Status check_for_commits(const BisectArguments& options) {
  const bool of_commits = !options.good.empty() || options.automatic;
  if (!of_commits && options.logs.size() > 2) {
    return bad_input("wanted two logs to compare, found " + std::to_string(options.logs.size()));
  }
  if (!of_commits) {
    return bad_input(
        "wanted two logs, or --good REV and --bad REV, or --auto\n'tumble bisect --help' explains the arguments.");
  }
  if (options.logs.size() > 1) {
    return bad_input("wanted one log with --good and --bad or --auto, found " + std::to_string(options.logs.size()));
  }
  if (options.logs.empty() == options.case_name.empty()) {
    return bad_input("wanted LOG, the session to ask about, or --case NAME in its place");
  }
  if (options.image && options.case_name.empty()) {
    return bad_input("--image: wanted --case NAME too, the case whose pictures are judged");
  }
  if (!options.metric.empty() && !options.case_name.empty()) return bad_input("--metric: does not go with --case");
  if (!options.run.empty() && !options.case_name.empty()) return bad_input("--run: does not go with --case");
  if (!options.scene.empty() && !options.case_name.empty()) {
    return bad_input("--scene: does not go with --case, which names the scene of the case");
  }
  if (!options.run.empty() && options.run.find("{log}") == std::string::npos) {
    return bad_input("--run: wanted {log} in the command line, where the log to write is put");
  }
  return check_passed_over(options);
}

void declare_arguments(Arguments& arguments, BisectArguments& target) {
  arguments.positionals("LOG", target.logs, "Two logs; or, with --good and --bad, the session to ask about");
  const Argument good = arguments.option("--good", "REV", target.good, "A good revision");
  const Argument bad = arguments.option("--bad", "REV", target.bad, "A later, bad revision");
  good.needs(bad);
  arguments
      .flag("--auto", target.automatic,
            "Find the good revision too: back from the bad one, or from HEAD, by 1, 2, 4 … first parents")
      .excludes(good);
  arguments
      .flag("--shared", target.shared,
            "Two logs: judge only what both have; a channel that one log alone has is named, and no difference")
      .excludes(good);
  declare_question(arguments, target);
  declare_building(arguments, target);
  arguments.json(target.json);
  arguments.footer(
      "docs/bisecting.md explains it. Revisions that do not build or cannot read the log are skipped. The clone's own\n"
      "files, index and branches are not touched.\n\n"
      "Exit status: 0 two logs are identical; 1 they differ, or the commit was found; 2 bad usage, or both revisions\n"
      "answer alike; 3 a damaged log; 4 interrupted, or the remaining commits could not be asked.\n\n"
      "Examples:\n"
      "  tumble bisect before.tumble after.tumble\n"
      "  tumble bisect --good v0.1 --bad main wall.tumble\n"
      "  tumble bisect --auto wall.tumble --cache ~/.cache/tumble-builds --jobs 2\n"
      "  tumble bisect --good HEAD~40 --bad HEAD grid.tumble --metric 'lateral_max<=0'\n"
      "  tumble bisect --good HEAD~40 --bad HEAD --case brick_wall --image");
}

}  // namespace tumble::tools
