#include "tools/view/packed_session.h"

#include <zlib.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "replay/view/contact_points.h"
#include "replay/view/packed_states.h"
#include "replay/view/timeline.h"
#include "src/base/check.h"
#include "tools/view/thinned_rows.h"
#include "tools/view/view_json.h"

namespace tumble::tools {
namespace {

constexpr std::uint64_t kBodyFramesMax = 3'000'000;  // kept in memory while it is found how many fit
constexpr std::size_t kTimelineRowsMax = 6000;       // of the timeline
constexpr std::uint64_t kContactShare = 4;           // contacts may take a quarter of the bytes
constexpr std::size_t kContactStepsMax = 60;

class Packer {
 public:
  Packer(replay::LogReader& log, const PackOptions& options, const replay::Progress& progress)
      : log_(log), options_(options), progress_(progress), table_(log.header()) {}

  Result<PackedSession> run() {
    if (Status ok = scan(); !ok.ok()) return ok.error();
    count_contacts_begun();
    std::string details = details_of({});
    const std::uint64_t left = options_.bytes_max - std::min<std::uint64_t>(options_.bytes_max, details.size());
    const std::uint64_t contact_bytes = left / kContactShare;
    std::string frames = fit_frames(left - contact_bytes);
    const Json contacts = contacts_within(contact_bytes);
    if (!contacts.empty()) details = details_of(contacts);
    Json head = head_json(log_);
    Json steps = Json::array();
    for (const std::size_t f : chosen_) steps.push_back(states_.steps()[f]);
    head["thin"] = {{"steps", steps},
                    {"every", stride_ * every_},
                    {"quantum", replay::PackedStates::kQuantum},
                    {"contact_steps", contacts.size()},
                    {"rows_run", run_}};
    return PackedSession{std::move(head), std::move(details), std::move(frames), unread_, std::move(why_unread_)};
  }

 private:
  Status scan() {
    const std::uint64_t bodies = std::max<std::uint64_t>(1, table_.bodies().size());
    stride_ = (log_.step_count() * bodies) / kBodyFramesMax + 1;
    replay::TimelineScan scan(log_, options_.bounds);
    while (!scan.done()) {
      const std::uint64_t k = scan.at();
      const replay::TimelineRow row = scan.next();
      rows_.push_back(row);
      if (!row.read && log_.lost_at(k) == nullptr && unread_++ == 0) why_unread_ = scan.why_not();
      const std::vector<sim::Command> inputs = scan.inputs();
      if (scan.record() != nullptr) table_.add(inputs, scan.record()->extras);
      for (const sim::Command& input : inputs) inputs_.push_back({k, input});
      const bool kept = must_keep(k) || !inputs.empty();
      if (row.read && (kept || (k - log_.first_state()) % stride_ == 0)) {
        if (kept) kept_.insert(states_.steps().size());
        states_.add(k, *scan.states(), table_);
      }
      if (progress_ && !progress_(k - log_.first_state(), log_.step_count())) return cannot_finish("interrupted");
    }
    return {};
  }

  [[nodiscard]] bool must_keep(std::uint64_t k) const {
    return k == log_.first_state() || k == log_.last_step() ||
           std::ranges::find(options_.keep, k) != options_.keep.end();
  }

  void count_contacts_begun() {
    begun_ = Json::array();
    if (log_.header().engine) return;
    replay::ContactScan contacts(log_);
    while (!contacts.done()) {
      const Result<replay::ContactScan::Row> row = contacts.next();
      if (!row.ok()) {
        begun_why_not_ = printable(row.error().message);
        return;
      }
      begun_.push_back(row->begun);
    }
  }

  [[nodiscard]] std::string details_of(const Json& contacts) {
    run_ = rows_.size() / kTimelineRowsMax + 1;
    const std::vector<replay::TimelineRow> rows = thinned_rows(rows_, run_);
    Json timeline = timeline_json(rows);
    timeline["begun"] = run_ == 1 ? begun_ : Json::array();
    timeline["begun_why_not"] = begun_why_not_;
    return deflated(dumped({{"bodies", bodies_json(table_)},
                            {"timeline", timeline},
                            {"inputs", inputs_json(inputs_)},
                            {"contacts", contacts.is_null() ? Json::object() : contacts}}));
  }

  /// Leaves out frames until they fit, evenly.
  std::string fit_frames(std::uint64_t bytes_max) {
    for (;; every_ += every_ / 8 + 1) {
      chosen_.clear();
      for (std::size_t f = 0; f < states_.steps().size(); ++f) {
        const bool in_turn = ((states_.steps()[f] - log_.first_state()) / stride_) % every_ == 0 &&
                             (states_.steps()[f] - log_.first_state()) % stride_ == 0;
        if (in_turn || kept_.contains(f)) chosen_.push_back(f);
      }
      std::string packed = deflated(states_.planes(chosen_, table_.bodies().size()));
      if (packed.size() <= bytes_max || every_ > states_.steps().size()) return packed;
      if (packed.size() > 2 * bytes_max) every_ = std::max(every_, every_ * packed.size() / (2 * bytes_max + 1));
    }
  }

  Json contacts_within(std::uint64_t bytes_max) {
    Json found = Json::object();
    if (bytes_max == 0 || chosen_.empty()) return found;
    replay::ContactSource source(log_);
    std::set<std::uint64_t> steps(options_.keep.begin(), options_.keep.end());
    const std::size_t apart = chosen_.size() / kContactStepsMax + 1;
    for (std::size_t i = 0; i < chosen_.size(); i += apart) steps.insert(states_.steps()[chosen_[i]]);
    // Evenly, also where few fit: first as many as all of the bytes allow by the middle one's size.
    std::uint64_t used = 0;
    const std::vector<std::uint64_t> ordered(steps.begin(), steps.end());
    std::size_t stride = 1;
    if (const auto middle = source.read(ordered[ordered.size() / 2]); middle.ok()) {
      const std::uint64_t each = deflated(dumped(contact_rows_json(*middle))).size() + 1;
      stride = static_cast<std::size_t>(each * ordered.size() / bytes_max) + 1;
    }
    for (std::size_t i = 0; i < ordered.size(); ++i) {
      const bool kept = std::ranges::find(options_.keep, ordered[i]) != options_.keep.end();
      if (!kept && i % stride != 0) continue;
      const auto points = source.read(ordered[i]);
      if (!points.ok()) continue;
      Json rows = contact_rows_json(*points);
      used += deflated(dumped(rows)).size();
      if (used > bytes_max) break;
      found[std::to_string(ordered[i])] = std::move(rows);
    }
    return found;
  }

  replay::LogReader& log_;
  const PackOptions& options_;
  const replay::Progress& progress_;
  replay::ViewedBodies table_;
  replay::PackedStates states_;
  std::vector<replay::TimelineRow> rows_;
  std::vector<replay::TimelineInput> inputs_;
  std::set<std::size_t> kept_;       // indices of frames that stay
  std::vector<std::size_t> chosen_;  // indices of frames
  std::uint64_t stride_ = 1, every_ = 1;
  std::size_t run_ = 1;
  Json begun_;
  std::string begun_why_not_;
  std::uint64_t unread_ = 0;
  std::string why_unread_;
};

}  // namespace

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int done = compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                             static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
  SIM_CHECK(done == Z_OK, done);
  out.resize(size);
  return out;
}

Result<PackedSession> pack_session(replay::LogReader& log, const PackOptions& options,
                                   const replay::Progress& progress) {
  return Packer(log, options, progress).run();
}

}  // namespace tumble::tools
