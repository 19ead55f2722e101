// tumble bench memory: the memory of a world, by body and by contact.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "src/world/memory_use.h"
#include "src/world/scratch.h"
#include "tools/bench/bench.h"
#include "tools/bench/peer_programs.h"
#include "tools/files/scene_files.h"
#include "tumble/replay/session.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::tools {
namespace {

/// The largest count of each at a time.
struct Counts {
  std::size_t bodies = 0, pairs = 0, contacts = 0;

  void see(const sim::World& world) {
    const sim::Scratch& scratch = world.scratch();
    bodies = std::max(bodies, world.bodies().size());
    pairs = std::max(pairs, world.state().pairs.size());
    const bool layered = world.state().def.method == sim::Method::kLayered;
    contacts = std::max(contacts, layered ? scratch.manifolds.size() : scratch.contacts.size());
  }
  [[nodiscard]] std::size_t of(sim::GrowsWith what) const {
    if (what == sim::GrowsWith::kBodies) return bodies;
    return what == sim::GrowsWith::kPairs ? pairs : contacts;
  }
};

const char* word_for(sim::GrowsWith what) {
  if (what == sim::GrowsWith::kBodies) return "body";
  return what == sim::GrowsWith::kPairs ? "pair" : "contact";
}

struct Use {
  std::string scene;
  Counts counts;
  std::vector<sim::MemoryPart> parts;

  [[nodiscard]] double each(sim::GrowsWith what) const {
    double bytes = 0;
    for (const sim::MemoryPart& part : parts) bytes += part.with == what ? static_cast<double>(part.bytes) : 0;
    return counts.of(what) == 0 ? 0 : bytes / static_cast<double>(counts.of(what));
  }
  [[nodiscard]] std::size_t total() const {
    std::size_t bytes = 0;
    for (const sim::MemoryPart& part : parts) bytes += part.bytes;
    return bytes;
  }
};

Result<Use> run(const sim::SceneDef& scene) {
  Result<replay::Session> session = replay::Session::start(scene);
  if (!session.ok()) return session.error();
  Use use;
  use.scene = scene.name;
  for (std::uint64_t k = 1; k <= scene.steps; ++k) {
    if (const Result<replay::TakenStep> taken = session->step(); !taken.ok()) return taken.error();
    use.counts.see(session->world());
  }
  use.parts = sim::memory_use(session->world());
  return use;
}

void print(const Use& use) {
  std::cout << '\n'
            << use.scene << ": " << use.counts.bodies << " bodies; at most " << use.counts.pairs << " pairs, "
            << use.counts.contacts << " contacts at a time\n";
  Table table({"part", ">bytes", ">each", "of"});
  for (const sim::MemoryPart& part : use.parts) {
    const std::size_t count = std::max<std::size_t>(use.counts.of(part.with), 1);
    table.add({part.name, std::to_string(part.bytes),
               short_number(static_cast<double>(part.bytes) / static_cast<double>(count)), word_for(part.with)});
  }
  for (const sim::GrowsWith what : {sim::GrowsWith::kBodies, sim::GrowsWith::kPairs, sim::GrowsWith::kContacts}) {
    table.add({"together", "", short_number(use.each(what)), word_for(what)});
  }
  table.add({"all", std::to_string(use.total()), "", ""});
  table.print();
}

Json to_json(const Use& use) {
  Json parts = Json::array();
  for (const sim::MemoryPart& part : use.parts) {
    parts.push_back({{"part", part.name}, {"bytes", part.bytes}, {"grows_with", word_for(part.with)}});
  }
  return {{"scene", use.scene},
          {"bodies", use.counts.bodies},
          {"pairs", use.counts.pairs},
          {"contacts", use.counts.contacts},
          {"bytes", use.total()},
          {"bytes_per_body", use.each(sim::GrowsWith::kBodies)},
          {"bytes_per_pair", use.each(sim::GrowsWith::kPairs)},
          {"bytes_per_contact", use.each(sim::GrowsWith::kContacts)},
          {"parts", parts}};
}

Result<sim::SceneDef> scene_called(const std::string& name, const std::vector<std::string>& overrides) {
  const Result<SceneFile> file = find_scene(name);
  if (!file.ok()) return file.error();
  const Result<std::string> text = read_scene(file->path);
  if (!text.ok()) return text.error();
  return scenes::parse_scene(*text, file->path, overrides);
}

}  // namespace

Result<Exit> bench_memory(const BenchOptions& options) {
  std::vector<std::string> names = options.scenes;
  if (names.empty()) names = {bench_scene_path("tilted_grid"), bench_scene_path("pile")};
  std::vector<std::string> overrides;
  if (!options.method.empty()) overrides.push_back("world.method=" + options.method);
  Json results = {{"bench", "memory"}, {"machine", machine_json()}, {"scenes", Json::array()}};
  std::vector<sim::SceneDef> scenes;
  for (const std::string& name : names) {  // all of them, before the work begins
    Result<sim::SceneDef> scene = scene_called(name, overrides);
    if (!scene.ok()) return scene.error();
    scenes.push_back(*std::move(scene));
  }
  FailedRuns failed;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Result<Use> use = run(scenes[i]);
    if (!use.ok()) {
      failed.add(names[i], use.error().message);
      continue;
    }
    results["scenes"].push_back(to_json(*use));
    if (!options.json) print(*use);
  }
  if (!options.json) failed.print();
  results["failures"] = failed.json();
  if (Status ok = give_results(options, results); !ok.ok()) return ok.error();
  if (Status ok = failed.status(); !ok.ok()) return ok.error();
  return Exit::kSame;
}

}  // namespace tumble::tools
