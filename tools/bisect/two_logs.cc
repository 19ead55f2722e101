#include "tools/bisect/two_logs.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "replay/diff/difference_report.h"
#include "replay/diff/locate_divergence.h"
#include "src/process/interrupt.h"
#include "tools/files/log_files.h"
#include "tools/output/difference_output.h"
#include "tools/output/divergence_output.h"
#include "tools/output/text.h"

namespace tumble::tools::bisect {

Result<Exit> locate_in_logs(const std::string& path_a, const std::string& path_b, bool json_wanted, bool shared) {
  Result<replay::LogReader> a = open_log(path_a);
  if (!a.ok()) return a.error();
  Result<replay::LogReader> b = open_log(path_b);
  if (!b.ok()) return b.error();
  const process::InterruptGuard guard;
  Result<replay::LocatedDivergence> located = replay::diff_and_locate(
      *a, *b, [](std::uint64_t, std::uint64_t) { return !process::InterruptGuard::interrupted(); });
  if (!located.ok()) return located.error();
  if (process::InterruptGuard::interrupted()) return cannot_finish("interrupted");
  if (located->report.first) name_bodies(*a, *b, *located->report.first);
  replay::name_by_own_axes(a->header(), b->header(), located->report, nullptr);
  const Sides sides = sides_of(*a, *b);
  const std::string excused =
      shared ? std::exchange(located->report.only_in, {}).text(sides.expected, sides.actual) : "";
  const replay::DiffReport& report = located->report;
  const std::size_t chunks = a->chunks().size() + b->chunks().size();
  const auto judge_both = [&] {
    return judge("bisect", *b, judge("bisect", *a, report.identical() ? Exit::kSame : Exit::kDifference));
  };
  if (json_wanted) {
    Json json = comparison_json(report.identical(), report.steps, report.first);
    json["only_in"] = only_in_json(report.only_in);
    json["read"] = read_of(*a, *b);
    add_scope(report.scope, json);
    json["notes"] = report.notes;
    json["cause"] = report.first ? Json(replay::cause_of(report, *report.first)) : Json(nullptr);
    json["narrowed"] = report.first ? location_json(located->location) : Json(nullptr);
    json["chunks_opened"] = located->chunks_opened;
    json["chunks"] = chunks;
    print_json("bisect", json);
    return judge_both();
  }
  for (const std::string& note : report.notes) std::cout << "note: " << printable(note) << '\n';
  if (report.first) {
    std::cout << "different from step " << report.first->step << " on\n";
    std::cout << "cause   " << printable(replay::cause_of(report, *report.first)) << '\n';
    print_divergence(*report.first, sides);
    print_location(located->location, sides);
    std::cout << "  opened      " << located->chunks_opened << " chunks of " << chunks << '\n';
  } else {
    std::cout << (report.identical() ? "identical: "
                                     : "different: " + printable(report.unequal(sides.expected, sides.actual)) +
                                           "; the same in all else that was compared: ")
              << count_text(report.steps, "step") << '\n';
    if (!excused.empty()) std::cout << "  though " << printable(excused) << ", as --shared allows\n";
    if (const std::string though = report.though(); !though.empty()) std::cout << "  " << though << '\n';
    print_scope(report.scope);
  }
  return judge_both();
}

}  // namespace tumble::tools::bisect
