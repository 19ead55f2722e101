// tumble bless: accepts the present results of cases as their goldens.
#include "tumble/golden/bless.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "golden/bless/bless_log.h"
#include "golden/suite/temporary_folder.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/files/scene_files.h"
#include "tools/output/check_output.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

struct BlessCommand {
  std::vector<std::string> cases;
  std::string suite;
  std::string reason;
  std::string log;
  std::string report;
  bool all = false;
  bool dry_run = false;
  std::optional<std::uint64_t> jobs;
  bool json = false;
};

Result<golden::BlessReport> run(const BlessCommand& options) {
  const std::string suite = options.suite.empty() ? find_suite() : options.suite;
  if (!options.log.empty()) {
    if (options.cases.size() != 1 || options.all) return bad_input("--from: wanted the name of one new case beside it");
    return golden::bless_log({suite, options.cases.front(), options.log, options.reason, options.dry_run});
  }
  if (options.cases.empty() != options.all && (options.report.empty() || options.all)) {
    return bad_input(options.all ? "found cases and --all, wanted one of the two"
                                 : "which cases? Give their names, or --all");
  }
  golden::BlessOptions how;
  how.suite = suite;
  how.names = options.cases;
  how.reason = options.reason;
  how.dry_run = options.dry_run;
  how.report = options.report;
  how.pool.jobs = options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency()));
  how.pool.cancel = process::InterruptGuard::interrupted;
  return golden::bless_cases(how);
}

Result<Exit> bless(const BlessCommand& options) {
  if (const Status ok = golden::check_temporary_place(); !ok.ok()) return ok.error();
  const process::InterruptGuard guard;
  const Result<golden::BlessReport> report = run(options);
  if (!report.ok()) return report.error();
  if (options.json) {
    print_json("bless", blessings_json(*report, options.dry_run));
  } else {
    print_blessings(*report, options.dry_run);
  }
  return Exit::kSame;
}

}  // namespace

Action declare_bless(Arguments& arguments) {
  auto options = std::make_shared<BlessCommand>();
  arguments.positionals("CASE", options->cases, "The cases to bless, or the name of a new one with --from");
  arguments.flag("--all", options->all, "Every case of the suite");
  arguments.option("--reason", "TEXT", options->reason, "The reason of the change: one line for HISTORY.md").required();
  const Argument from = arguments.option("--from", "LOG", options->log, "Make a new case of this recorded session");
  arguments
      .option(
          "--from-report", "DIR", options->report,
          "Accept the sessions of failed cases that the report of a check elsewhere holds, without running them; it "
          "must be of the commit that this program was built at")
      .excludes(from);
  arguments.flag("--dry-run", options->dry_run, "Print the changes and write nothing");
  arguments.option("--suite", "DIR", options->suite,
                   "The suite: a folder with cases/ in it; the nearest golden/ if not given");
  arguments.whole("--jobs", "N", options->jobs, 1, 1024, "Cases at a time; as many as processors if not given");
  arguments.json(options->json);
  arguments.footer(
      "Replaces expected.tumble and the values in metrics.toml; bounds stay. A metric out of its bounds is refused:\n"
      "change the bound, and its reason, in metrics.toml first. HISTORY.md records each change\n"
      "with its size and its reason.\n\n"
      "Examples:\n"
      "  tumble bless brick_wall --reason \"contacts are found before planes are cached\" --dry-run\n"
      "  tumble bless --all --reason \"method thesis, version 2\"\n"
      "  tumble bless two_walls --from session.tumble --reason \"the wall that fell in the field\"");
  return [options] { return bless(*options); };
}

}  // namespace tumble::tools
