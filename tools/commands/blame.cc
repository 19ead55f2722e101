// tumble blame: from a value of a body back to what wrote it.
#include "replay/blame/blame.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "replay/blame/body_contacts.h"
#include "replay/measure/measure_options.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/compare/blame_output.h"
#include "tools/files/log_files.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

constexpr std::uint64_t kBackMax = 1000;

struct BlameCommand {
  std::string log;
  std::string body_named;
  std::optional<std::uint64_t> body;  // as the log has it
  std::optional<std::uint64_t> step;
  std::optional<std::uint64_t> back;
  std::string field;
  bool contacts = false;
  bool json = false;
};

Result<Exit> show_contacts(const BlameCommand& options, replay::LogReader& log) {
  ProgressBar bar("stepping again");
  const Result<replay::BodyContacts> found =
      replay::contacts_of_body(log, *options.body, options.step.value_or(log.last_step()), bar.progress());
  bar.finish();
  if (!found.ok()) return found.error();
  if (options.json) {
    print_json("blame", contacts_json(*found));
  } else {
    print_contacts(*found);
  }
  return judge("blame", log, Exit::kSame);
}

Result<Exit> blame(BlameCommand options) {
  Result<replay::LogReader> log = open_log(options.log);
  if (!log.ok()) return log.error();
  const Result<sim::BodyId> body = replay::parse_body(options.body_named, log->bodies());
  if (!body.ok()) return bad_input("--body: " + body.error().message);
  options.body = *body;
  const process::InterruptGuard guard;
  if (options.contacts) return show_contacts(options, *log);
  replay::BlameQuestion question;
  question.body = *options.body;
  question.field = options.field;
  question.step = options.step.value_or(log->last_step());
  question.answers = static_cast<std::uint32_t>(options.back.value_or(1));
  ProgressBar bar("stepping again");
  const Result<replay::Blame> found = replay::blame(*log, question, bar.progress());
  bar.finish();
  if (!found.ok()) return found.error();
  if (options.json) {
    print_json("blame", blame_json(*found));
  } else {
    print_blame(*found);
  }
  if (found->damaged && log->condition().whole()) {  // opening a log reads no step
    std::cerr << "tumble blame: " << printable(found->ends) << "; 'tumble recover' saves the intact part\n";
    return Exit::kDamaged;
  }
  return judge("blame", *log, Exit::kSame);
}

std::vector<std::string> field_words() {
  std::vector<std::string> words = {replay::kColumnNames.begin(), replay::kColumnNames.end()};
  words.emplace_back("frozen");
  return words;
}

}  // namespace

Action declare_blame(Arguments& arguments) {
  auto options = std::make_shared<BlameCommand>();
  arguments.positional("LOG", options->log, "The log to explain").required();
  arguments.option("--body", "ID", options->body_named, "The body whose value is asked about, by its id or its name")
      .required();
  const Argument field =
      arguments
          .option("--field", "NAME", options->field,
                  "The value: position.x, orientation.w, velocity.x, spin.x (angular velocity), frozen, …; unless "
                  "given, the component of position that changed most in step K")
          .offers(field_words());
  arguments.whole("--step", "K", options->step, 0, sim::kStepsMax,
                  "The value after step K; the last step unless given");
  const Argument back =
      arguments.whole("--back", "N", options->back, 1, kBackMax,
                      "Print up to N answers, each on what the one before it came from; 1 unless given");
  arguments
      .flag("--contacts", options->contacts,
            "Instead: everything that touched the body in step K, substep by substep, its island and its load")
      .excludes(field)
      .excludes(back);
  arguments.json(options->json);
  arguments.footer(
      "Names the phase and substep that last changed the value, the value before and after, and the shares of the\n"
      "contacts that took part; or the input; or the scene. The steps are taken again by this build from the nearest\n"
      "keyframe and compared with the log's: what this build does not repeat, it does not explain (status 4).\n\n"
      "Examples:\n"
      "  tumble blame crash.tumble --body 12 --field velocity.x --step 75\n"
      "  tumble blame crash.tumble --body 12 --field position.z --step 75 --back 10\n"
      "  tumble blame crash.tumble --body 12 --field frozen --json\n"
      "  tumble blame crash.tumble --body 12 --step 75 --contacts");
  return [options] { return blame(*options); };
}

}  // namespace tumble::tools
