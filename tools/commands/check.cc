// tumble check: runs the golden suite with this build.
#include "tumble/golden/check.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "golden/bundle/bundle.h"
#include "golden/bundle/merge.h"
#include "golden/report/annotations.h"
#include "golden/report/report_json.h"
#include "golden/report/report_place.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/shard.h"
#include "tools/files/scene_files.h"
#include "tools/output/check_output.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/golden/report.h"

namespace tumble::tools {
namespace {

constexpr double kTimeoutMax = 1e6;
constexpr double kTimeout = 600;  // s: many times what the longest case takes in the slowest build

struct CheckCommand {
  std::vector<std::string> cases;
  std::string suite;
  std::vector<std::string> require;
  std::string report = "report";
  std::string junit;
  std::string annotate;
  std::string shard;
  std::string category;
  std::optional<std::uint64_t> jobs;
  std::optional<double> timeout;
  bool merge = false;
  bool heavy = false;
  bool json = false;
};

Result<golden::CheckOptions> check_options(const CheckCommand& options) {
  golden::CheckOptions out;
  out.suite = options.suite.empty() ? find_suite() : options.suite;
  out.selection.names = options.cases;
  out.selection.category = options.category;
  const Result<Shard> shard = read_shard(options.shard);
  if (!shard.ok()) return shard.error();
  out.selection.shard = shard->k;
  out.selection.shards = shard->n;
  if (!options.annotate.empty() && options.annotate != "github" && options.annotate != "gitlab") {
    return bad_input("--annotate: found " + in_quotes(options.annotate) + ", wanted github or gitlab");
  }
  if (!options.require.empty()) out.require.emplace();
  for (const std::string& word : options.require) {
    const Result<golden::VerdictKind> kind = golden::parse_verdict(word);
    if (!kind.ok()) return bad_input("--require: " + kind.error().message);
    out.require->push_back(*kind);
  }
  out.heavy = options.heavy;
  out.report = options.report;
  out.junit = options.junit;
  out.pool.jobs = options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency()));
  out.pool.timeout_s = options.timeout.value_or(kTimeout);
  out.pool.cancel = process::InterruptGuard::interrupted;
  return out;
}

Exit verdict_of(const golden::SuiteResult& result) {
  if (!result.canaries_caught()) return Exit::kCannotFinish;
  return result.passed() ? Exit::kSame : Exit::kDifference;
}

/// Shows the failures beside the change, in a CI service that knows them in this form.
Status annotate(const CheckCommand& options, const golden::SuiteResult& result) {
  const char* const checkout = std::getenv(options.annotate == "github" ? "GITHUB_WORKSPACE" : "CI_PROJECT_DIR");
  const std::vector<golden::Annotation> failures = golden::annotations(result, checkout == nullptr ? "" : checkout);
  if (options.annotate == "github") (options.json ? std::cerr : std::cout) << golden::github_commands(failures);
  if (options.annotate != "gitlab") return {};
  return golden::write_file(golden::findings_file(options.report),
                            std::string_view(golden::gitlab_findings(failures).dump(2) + '\n'));
}

/// Writes the files of the report, the bundle last, and prints the result.
Result<Exit> tell(const CheckCommand& options, const golden::SuiteResult& result) {
  if (Status ok = golden::write_reports(result, options.report, options.junit); !ok.ok()) return ok.error();
  if (Status ok = annotate(options, result); !ok.ok()) return ok.error();
  if (Status ok = golden::write_bundle(result, options.report); !ok.ok()) return ok.error();
  if (options.json) {
    print_json("check", golden::report_json(result));
  } else {
    print_sum(result, result.suite, options.report);
  }
  if (!result.canaries_caught()) {
    std::cerr
        << "tumble check: a comparison of known outcome came out otherwise: this build cannot be trusted, and none of "
           "its verdicts counts\n";
  }
  return verdict_of(result);
}

Result<Exit> merge(const CheckCommand& options) {
  golden::MergeOptions how;
  how.bundles.assign(options.cases.begin(), options.cases.end());
  how.report = options.report;
  if (how.bundles.empty()) return bad_input("--merge: found no folder, wanted the --report of every shard");
  if (Status ok = golden::check_merged_report(how.bundles, options.report, options.junit); !ok.ok()) return ok.error();
  how.make_ready = [&] { return golden::prepare_merged_report(how.bundles, options.report, options.junit); };
  ProgressBar bar("merging");
  how.progress = [&](std::size_t done, std::size_t total) { bar.show(done, total); };
  const Result<golden::SuiteResult> result = golden::merge_bundles(how);
  bar.finish();
  if (!result.ok()) return result.error();
  for (const golden::CaseResult& one : result->cases) {
    if (!options.json && !one.passed()) print_case(one);
  }
  return tell(options, *result);
}

Result<Exit> check(const CheckCommand& options) {
  Result<golden::CheckOptions> how = check_options(options);
  if (!how.ok()) return how.error();
  if (options.merge) return merge(options);
  if (const Status ok = golden::check_temporary_place(); !ok.ok()) return ok.error();
  const process::InterruptGuard guard;
  ProgressBar bar("checking");
  how->progress = [&](const golden::CaseResult& one, std::size_t done, std::size_t total) {
    bar.finish();
    if (!options.json) print_case(one);
    std::cout.flush();
    bar.show(done, total);
  };
  const Result<golden::SuiteResult> result = golden::check_suite(*how);
  bar.finish();
  if (!result.ok()) return result.error();
  return tell(options, *result);
}

}  // namespace

Action declare_check(Arguments& arguments) {
  auto options = std::make_shared<CheckCommand>();
  arguments.positionals("CASE", options->cases,
                        "Cases to run, all if none is given; with --merge: the report folders of all shards");
  const Argument merge =
      arguments.flag("--merge", options->merge, "Run nothing; merge the reports of the shards of one check");
  arguments
      .option("--suite", "DIR", options->suite,
              "The suite: a folder with cases/ in it; the nearest golden/ if not given")
      .excludes(merge);
  arguments.option("--category", "NAME", options->category, "Only cases of this category").excludes(merge);
  arguments
      .option("--require", "VERDICT", options->require,
              "A verdict that decides, instead of each case's own: exact, behaviour or image; may be repeated")
      .offers({"exact", "behaviour", "image"})
      .excludes(merge);
  arguments
      .flag("--heavy", options->heavy,
            "Also go on with each session from a snapshot of every step; the bits must be those of the session")
      .excludes(merge);
  arguments.option("--report", "DIR", options->report,
                   "The folder for index.html, junit.xml, report.json and the logs of failed "
                   "cases; report if not given");
  arguments.option("--junit", "FILE", options->junit, "Write junit.xml to this file instead");
  arguments
      .option("--annotate", "SERVICE", options->annotate,
              "Show failures beside the change: github (workflow commands are printed) or gitlab (the report gets "
              "gl-code-quality-report.json)")
      .offers({"github", "gitlab"});
  arguments
      .option("--shard", "K/N", options->shard,
              "Only the K-th of N parts of the suite; auto: as the environment of the build system says")
      .excludes(merge);
  arguments.whole("--jobs", "N", options->jobs, 1, 1024, "Cases at a time; as many as processors if not given")
      .excludes(merge);
  arguments.positive("--timeout", "S", options->timeout, kTimeoutMax, "Seconds a case may take; 600 if not given")
      .excludes(merge);
  arguments.json(options->json);
  arguments.footer(
      "Exit status: 0 all passed, 1 a case failed, 2 bad usage or no such case or suite, 4 could not finish, or a\n"
      "canary (a comparison of known outcome; each check makes all, in shards each in one) was not caught. With "
      "--merge\n"
      "also 2 for a shard that is missing, there twice or of another check, 3 for one that is damaged; the message "
      "names each.\n\n"
      "Examples:\n"
      "  tumble check\n"
      "  tumble check brick_wall tower --report build/report\n"
      "  tumble check --heavy --timeout 3600\n"
      "  tumble check --junit junit.xml --annotate github\n"
      "  tumble check --suite my_engine/goldens --require behaviour --shard 1/4 --report shard-1\n"
      "  tumble check --merge shard-1 shard-2 shard-3 shard-4 --report report");
  return [options] { return check(*options); };
}

}  // namespace tumble::tools
