#include "replay/log/log_facts.h"

#include <algorithm>
#include <set>
#include <variant>

#include "replay/log/record_reader.h"
#include "replay/log/session_clock.h"
#include "replay/log/told_values.h"

namespace tumble::replay {
namespace {

class FactCounter {
 public:
  explicit FactCounter(LogReader& log) : log_(log), told_(log.header()) {
    facts_.bodies_at_start = log.header().scene.boxes.size();
    facts_.moving_body_steps = 0;
    for (const sim::BoxDef& box : log.header().scene.boxes) note(box);
    if (Result<const StepRecord*> start = log.read_step(log.first_state()); start.ok()) {
      facts_.final_hash = (*start)->state_hash;
      told_.add(**start);
    }
  }

  LogFacts run(const Progress& progress) {
    for (const ChunkPlace& place : log_.chunks()) {
      for (std::uint64_t k = place.first_step; k < place.end_step(); ++k) {
        const Result<const StepRecord*> record = log_.read_step(k);
        if (!record.ok()) break;  // the rest of the chunk cannot be read either
        count(**record);
        if (progress && !progress(k - log_.first_state(), log_.step_count())) return facts_;
      }
    }
    facts_.seconds = clock_.now();
    facts_.told = told_.note();
    return facts_;
  }

 private:
  /// Returns whether no body had its id before.
  bool note(const sim::BoxDef& box) {
    if (box.is_static) statics_.insert(box.id);
    return ids_.insert(box.id).second;
  }

  void count(const StepRecord& record) {
    ++facts_.steps_read;
    told_.add(record);
    clock_.add_step(record.dt);
    facts_.dt_min = std::min(facts_.dt_min.value_or(record.dt), record.dt);
    facts_.dt_max = std::max(facts_.dt_max.value_or(record.dt), record.dt);
    facts_.final_hash = record.state_hash;
    for (const sim::Command& input : record.inputs) {
      ++facts_.inputs[sim::name_of(input)];
      const auto* thrown = std::get_if<sim::Throw>(&input);
      if (thrown != nullptr && note(thrown->box)) ++facts_.bodies_thrown;
    }
    if (!record.has_states) facts_.moving_body_steps.reset();
    if (!facts_.moving_body_steps) return;
    const BodyStates& states = record.states;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states.frozen[i] == 0 && !statics_.contains(states.id[i])) ++*facts_.moving_body_steps;
    }
  }

  LogReader& log_;
  LogFacts facts_;
  ToldWatch told_;
  SessionClock clock_;
  std::set<sim::BodyId> ids_, statics_;
};

/// Of the steps up to step `last` alone, where bodies_until() has those of whole chunks.
BodyTable bodies_told_by(LogReader& log, std::uint64_t last) {
  if (last >= log.last_step()) return log.bodies();
  BodyTable bodies;
  bodies.add(log.header().declared.bodies, log.header().declared.shapes);
  for (std::uint64_t k = log.first_state() + 1; k <= last; ++k) {
    if (!log.holds(k)) continue;
    const Result<const StepRecord*> record = log.read_hashes(k);
    if (record.ok()) bodies.add((*record)->extras.bodies, (*record)->extras.shapes);
  }
  return bodies;
}

}  // namespace

std::optional<double> LogFacts::bytes_per_moving_body_step(std::uint64_t file_bytes) const {
  if (!moving_body_steps || *moving_body_steps == 0) return std::nullopt;
  return static_cast<double>(file_bytes) / static_cast<double>(*moving_body_steps);
}

LogFacts collect_facts(LogReader& log, const Progress& progress) { return FactCounter(log).run(progress); }

bool dt_varies(LogReader& log) {
  std::optional<double> first;
  for (const ChunkPlace& place : log.chunks()) {
    for (std::uint64_t k = place.first_step; k < place.end_step(); ++k) {
      const Result<const StepRecord*> record = log.read_hashes(k);
      if (!record.ok()) break;  // the rest of the chunk cannot be read either
      if (first && (*record)->dt != *first) return true;
      first = (*record)->dt;
    }
  }
  return false;
}

Status read_start(LogReader& log, std::uint64_t from, StepRecord& start) {
  Result<const StepRecord*> record = log.read_step(from);
  if (!record.ok()) return record.error();
  start.step = from;
  start.state_hash = (*record)->state_hash;
  start.has_states = (*record)->has_states;
  start.states = (*record)->states;
  start.extras = (*record)->extras;
  return {};
}

BodyTable bodies_until(const LogReader& log, std::uint64_t last) {
  const LogHeader& header = log.header();
  BodyTable bodies;
  bodies.add(header.declared.bodies, header.declared.shapes);
  if (!header.engine) return bodies;
  const RecordReader records(log.source());
  const ChunkRules rules = rules_of(log.header_prelude(), header);
  for (const ChunkPlace& place : log.chunks()) {
    if (place.first_step > last) break;
    records.add_bodies(place, rules, bodies);
  }
  return bodies;
}

bool tells_dt(const LogReader& log) { return !log.header().engine || log.first_state() < log.last_step(); }

void add_notes_on_cuts(const LogReader& a, const LogReader& b, std::vector<std::string>& notes) {
  for (const LogReader* log : {&a, &b}) {
    ToldWatch told(log->header());
    told.add(log->first_state(), log->header().declared.start);
    if (const std::string cut = told.note(); !cut.empty()) notes.push_back(log->name() + ": " + cut);
  }
}

bool tells_contacts(LogReader& log, std::uint64_t last) {
  if (!log.header().declared.start.contacts.empty()) return true;
  for (const ChunkPlace& place : log.chunks()) {
    for (std::uint64_t k = place.first_step; k < place.end_step() && k <= last; ++k) {
      const Result<const StepRecord*> record = log.read_hashes(k);
      if (!record.ok()) break;  // the rest of the chunk cannot be read either
      if (!(*record)->extras.contacts.empty()) return true;
    }
  }
  return false;
}

void add_later_shapes(LogReader& one, LogReader& other, std::uint64_t last, std::vector<std::string>& parts) {
  const auto begins_with = [](const LogReader& log, sim::BodyId id) {
    return std::ranges::binary_search(log.header().declared.bodies, id, {}, &BodyInfo::id);
  };
  const BodyTable in_one = bodies_told_by(one, last), in_other = bodies_told_by(other, last);
  const std::map<sim::BodyId, BodyInfo>& there = in_other.bodies();
  for (const auto& [id, body] : in_one.bodies()) {
    if (body.shape == Hash128() || begins_with(one, id) || begins_with(other, id)) continue;
    const auto its = there.find(id);
    if (its != there.end() && its->second.shape == body.shape) continue;
    parts.push_back("this shape of body " + std::to_string(id));
  }
}

// A chain value is a hash over all steps before, so two chains that differ once never agree again: a binary search
// finds the place. If log B ends a chunk at that step too, the index of each log has the value, and no chunk is
// decoded.
Result<std::uint64_t> last_of_one_chain(LogReader& a, LogReader& b, std::uint64_t from, std::uint64_t last) {
  const Result<Hash128> chain_a = a.chain_at(from), chain_b = b.chain_at(from);
  if (!chain_a.ok() || !chain_b.ok()) return chain_a.ok() ? chain_b.error() : chain_a.error();
  if (*chain_a != *chain_b) return from;
  const std::vector<ChunkPlace>& chunks = a.chunks();
  const auto ends_by = [](std::uint64_t step, const ChunkPlace& place) { return step < place.end_step() - 1; };
  auto low =
      std::upper_bound(chunks.begin(), chunks.end(), from, ends_by);  // all chunks before it are known to be equal
  auto high = std::upper_bound(chunks.begin(), chunks.end(), last, ends_by);
  std::uint64_t same = from;
  while (low < high) {
    const auto middle = low + (high - low) / 2;
    const Result<Hash128> other = b.chain_at(middle->end_step() - 1);  // no answer where a record is damaged
    if (other.ok() && *other == middle->chain_after) {
      same = middle->end_step() - 1;
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return same;
}

}  // namespace tumble::replay
