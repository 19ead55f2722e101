#include "golden/hunt/engine/trace_engine.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

#include "golden/engine/engine_run.h"
#include "golden/engine/session_file.h"
#include "golden/engine/table_reading.h"
#include "golden/hunt/engine/kept_run.h"
#include "golden/hunt/judge/bounds.h"
#include "golden/hunt/judge/unmet.h"
#include "golden/hunt/scene/scene_text.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/process/run_child.h"
#include "src/world/edit_bodies.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/step.h"

namespace tumble::hunt {
namespace {

namespace fs = std::filesystem;
using sim::Bodies;
using sim::BodyIndex;

constexpr double kPatience = 60;  // s, where the engine's tumble.toml gives none
constexpr int kRefused = 2;       // the status of an engine that cannot run the scene

// What an input changes where Tumble's own apply() refuses the state, which need not lie on our grids.
void apply_roughly(sim::WorldState& state, const sim::Command& input) {
  if (const auto* gravity = std::get_if<sim::SetGravity>(&input)) state.def.gravity = gravity->gravity;
  if (const auto* dt = std::get_if<sim::SetDt>(&input)) state.def.dt = dt->dt;
  if (const auto* thrown = std::get_if<sim::Throw>(&input)) sim::insert_body(state, thrown->box);
  if (const auto* removed = std::get_if<sim::Remove>(&input)) {
    if (const auto i = state.bodies.find(removed->id)) sim::erase_body(state, *i);
  }
  if (const auto* push = std::get_if<sim::Push>(&input)) {
    const auto i = state.bodies.find(push->id);
    if (i) state.bodies.velocity.set(*i, state.bodies.velocity[*i] + push->impulse / state.bodies.mass[*i]);
  }
  if (const auto* set = std::get_if<sim::SetVelocity>(&input)) {
    const auto i = state.bodies.find(set->id);
    if (i) state.bodies.velocity.set(*i, set->velocity);
    if (i) state.bodies.spin.set(*i, set->spin);
  }
}

sim::WorldState with_inputs(const sim::WorldState& before, const std::vector<sim::Command>& inputs) {
  Result<sim::World> world = sim::World::restore(before);
  const bool taken = world.ok() && std::ranges::all_of(inputs, [&world](const sim::Command& input) {
                       return sim::apply(*world, input).ok();
                     });
  if (taken) return world->state();
  sim::WorldState state = before;
  for (const sim::Command& input : inputs) apply_roughly(state, input);
  return state;
}

// The columns of a step of the log in the place of those of a state. Bodies that the log lacks are removed.
void take_columns(sim::WorldState& state, std::uint64_t step, const replay::BodyStates& found) {
  state.step = step;
  Bodies& bodies = state.bodies;
  for (BodyIndex i = 0; i < bodies.size();) {
    const auto at = std::ranges::lower_bound(found.id, bodies.id[i]);
    if (at == found.id.end() || *at != bodies.id[i]) {
      sim::erase_body(state, i);
      continue;
    }
    const auto row = static_cast<std::size_t>(at - found.id.begin());
    bodies.position.set(i, found.position[row]);
    bodies.orientation.set(i, found.orientation[row]);
    bodies.velocity.set(i, found.velocity[row]);
    bodies.spin.set(i, found.spin[row]);
    bodies.frozen[i] = found.frozen[row];
    ++i;
  }
}

std::string listed(const std::vector<sim::BodyId>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 4); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(ids[i]);
  return text + (ids.size() > 4 ? " and " + std::to_string(ids.size() - 4) + " more" : "");
}

// How the bodies of a state of the log differ from those that the scene and the inputs leave there; empty: not at all.
// A static body more is the engine's ground or wall.
std::string other_bodies(const Bodies& wanted, const replay::BodyStates& found, const replay::LogHeader& header) {
  std::vector<sim::BodyId> missing, more;
  std::ranges::set_difference(wanted.id, found.id, std::back_inserter(missing));
  std::ranges::set_difference(found.id, wanted.id, std::back_inserter(more));
  std::erase_if(more, [&header](sim::BodyId id) {
    const auto box = std::ranges::lower_bound(header.scene.boxes, id, {}, &sim::BoxDef::id);
    return box != header.scene.boxes.end() && box->id == id && box->is_static;
  });
  std::string text;
  if (!missing.empty()) text = "it lacks body " + listed(missing);
  if (!more.empty()) text += (text.empty() ? "it has body " : " and has body ") + listed(more) + " too";
  return text;
}

// The states of the log, with what the scene says of the bodies.
Trace read_session(replay::LogReader& log, Trace trace, sim::WorldState state) {
  if (log.header().engine) {  // not Tumble's own
    trace.scene.world.method = sim::Method::kLayered;
    trace.scene.world.substeps = 1;
    if (log.header().engine->precision_bits <= replay::kBinary32Bits) trace.rounding = kRoundingOfFloats;
  }
  state.def = trace.scene.world;
  const std::uint64_t last = std::min<std::uint64_t>(log.last_step(), trace.scene.steps);
  for (std::uint64_t k = 0; k <= last; ++k) {
    const Result<const replay::StepRecord*> record = log.read_step(k);
    if (!record.ok() || !(*record)->has_states) {
      trace.failure = record.ok() ? "its log lacks states" : "its log: " + record.error().message;
      break;
    }
    TracedStep step;
    step.dt = (*record)->dt;
    if (k > 0 && !(*record)->inputs.empty()) {
      step.inputs = (*record)->inputs;
      state = with_inputs(state, step.inputs);
      step.begun = state;
    }
    if (const std::string other = other_bodies(state.bodies, (*record)->states, log.header()); !other.empty()) {
      trace.other_bodies = k;
      trace.failure = "state " + std::to_string(k) + " of its session has other bodies than the scene: " + other;
      break;
    }
    if (k > 0) trace.steps.push_back(std::move(step));
    take_columns(state, k, (*record)->states);
    trace.states.push_back(state);
    if (k > 0) trace.steps.back().met = may_have_met(trace, k - 1);
  }
  if (trace.states.empty()) trace.states.push_back(std::move(state));
  if (trace.failure.empty() && last < trace.scene.steps)
    trace.failure = "it wrote " + std::to_string(last) + " of " + std::to_string(trace.scene.steps) + " steps";
  return trace;
}

// State 0 as the scene says it: the bodies by id, in whatever order the engine gets them.
Result<sim::World> world_of(const sim::SceneDef& scene) {
  sim::SceneDef by_id = scene;
  std::ranges::sort(by_id.boxes, {}, &sim::BoxDef::id);
  return sim::create_world(by_id);
}

/// In one line, as findings are.
std::string what_it_printed(const fs::path& said) { return replaced(golden::end_of_output(said), "\n", " | "); }

}  // namespace

Result<Trace> trace_of_log(replay::LogReader& log, const sim::SceneDef& scene, const golden::EngineProject& project) {
  const Result<sim::World> start = world_of(scene);
  if (!start.ok()) return start.error();
  Trace trace;
  trace.scene = scene;
  trace.external = true;
  trace.fall = golden::fall_in_a_step(project);
  return read_session(log, std::move(trace), start->state());
}

Result<Trace> trace_engine(const golden::EngineProject& project, const sim::SceneDef& scene, const fs::path& scratch) {
  const auto ran = std::make_shared<EngineFiles>(scratch);
  const fs::path folder = ran->folder.path();
  if (folder.empty()) return cannot_finish("no temporary folder could be made");
  const fs::path toml = folder / "scene.toml", said = folder / "said";
  ran->said = said;
  ran->wrote = folder / "wrote";
  const golden::RunFiles files = {toml.string(), "", (folder / "session.tumble").string(), ""};
  if (const Status ok = golden::write_file(toml, scene_text(scene)); !ok.ok()) return ok.error();
  Trace trace;
  trace.scene = scene;
  trace.external = true;
  trace.fall = golden::fall_in_a_step(project);
  trace.ran = ran;
  trace.again = [&project, scratch](const sim::SceneDef& other) { return trace_engine(project, other, scratch); };
  const Result<sim::World> start = world_of(scene);
  if (!start.ok()) return start.error();
  const Result<std::vector<std::string>> words = golden::engine_words(project, project.run, files);
  if (!words.ok()) return words.error();
  process::Program child;
  child.words = *words;
  child.folder = project.folder.string();
  child.out = child.err = said.string();
  child.own_group = false;  // it ends with the process that judges
  const Result<process::ChildEnd> end =
      process::run_child(child, project.timeout_s > 0 ? project.timeout_s : kPatience);
  if (end.ok() && end->late) process::end_own_group();
  if (!end.ok()) return cannot_finish("the engine does not start: " + end.error().message);
  if (end->exit == kRefused) return bad_input("the engine refuses the scene" + what_it_printed(said));
  const auto fails = [&](std::string why) {
    trace.failure = std::move(why);
    trace.states.push_back(start->state());
    return std::move(trace);
  };
  std::error_code ignored;  // it may have written nothing
  if (fs::is_regular_file(files.log, ignored)) fs::copy_file(files.log, ran->wrote, ignored);
  if (!end->well()) return fails("the engine " + end->text() + what_it_printed(said));
  if (const Status ok = golden::rewrite_table(files.log, project.table, project.folder); !ok.ok())
    return fails(ok.error().message);
  const Result<golden::SessionLog> session =
      golden::log_of_session(files.log, (folder / "converted.tumble").string(), nullptr);
  if (!session.ok()) return fails(session.error().message);
  Result<replay::LogReader> log = replay::LogReader::open(session->path);
  if (!log.ok()) return fails(log.error().message);
  return read_session(*log, std::move(trace), start->state());
}

}  // namespace tumble::hunt
