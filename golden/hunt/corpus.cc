#include "golden/hunt/corpus.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "golden/hunt/batch.h"
#include "golden/hunt/judge/features.h"
#include "golden/suite/text_files.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/hash.h"

namespace tumble::hunt {
namespace {

namespace fs = std::filesystem;

Result<std::vector<fs::path>> scenes_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".toml") files.push_back(entry->path());
  }
  if (error) return bad_input(folder.string() + ": cannot be read: " + error.message());
  std::ranges::sort(files);
  return files;
}

Result<TextScene> read_scene(const fs::path& file) {
  Result<std::string> text = golden::read_text(file);
  if (!text.ok()) return text.error();
  Result<sim::SceneDef> scene = scenes::parse_scene(*text, file.string());
  if (!scene.ok()) return scene.error();
  return TextScene{*std::move(text), *std::move(scene)};
}

// The first half of a hash of the text: two corpora name one scene alike.
std::string name_of_text(const std::string& text) {
  Hasher hasher;
  hasher.add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  return to_string(hasher.digest()).substr(0, 16) + ".toml";
}

}  // namespace

Result<Corpus> Corpus::open(const fs::path& folder) {
  Corpus corpus(folder);
  std::error_code error;
  if (!fs::exists(folder, error)) return corpus;
  Result<std::vector<fs::path>> files = scenes_in(folder);
  if (!files.ok()) return files.error();
  for (const fs::path& file : *files) {
    const Result<TextScene> scene = read_scene(file);
    if (!scene.ok()) return scene.error();
    const Result<Trace> session = trace(scene->scene);
    if (!session.ok()) return bad_input(file.string() + ": " + session.error().message);
    const std::vector<std::string> features = features_of(*session);
    corpus.features_.insert(features.begin(), features.end());
  }
  corpus.files_ = *std::move(files);
  return corpus;
}

Result<bool> Corpus::add(const TextScene& scene, const std::vector<std::string>& features) {
  const bool fresh = std::ranges::any_of(features, [this](const std::string& one) { return !features_.contains(one); });
  if (!fresh) return false;
  const fs::path file = folder_ / name_of_text(scene.text);
  if (Status ok = golden::write_file(file, scene.text); !ok.ok()) return ok.error();
  features_.insert(features.begin(), features.end());
  files_.insert(std::ranges::upper_bound(files_, file), file);
  return true;
}

Result<std::size_t> Corpus::merge(const fs::path& other) {
  const Result<std::vector<fs::path>> files = scenes_in(other);
  if (!files.ok()) return files.error();
  std::size_t added = 0;
  for (const fs::path& file : *files) {
    const Result<TextScene> scene = read_scene(file);
    if (!scene.ok()) return scene.error();
    const Result<Trace> session = trace(scene->scene);
    if (!session.ok()) return bad_input(file.string() + ": " + session.error().message);
    const Result<bool> fresh = add(*scene, features_of(*session));
    if (!fresh.ok()) return fresh.error();
    if (*fresh) ++added;
  }
  return added;
}

Result<CorpusResult> judge_corpus(const fs::path& folder, const Question& question, const process::PoolOptions& pool) {
  const Result<std::vector<fs::path>> files = scenes_in(folder);
  if (!files.ok()) return files.error();
  if (files->empty()) return bad_input(folder.string() + ": found no scene, wanted files NAME.toml");
  std::vector<TextScene> scenes;
  for (const fs::path& file : *files) {
    Result<TextScene> scene = read_scene(file);
    if (!scene.ok()) return scene.error();
    scenes.push_back(*std::move(scene));
  }
  CorpusResult out;
  out.scenes = scenes.size();
  for (const std::string& name : names_of(question)) out.relations.emplace_back(name, Tally{});
  std::map<std::size_t, process::JobResult> done;
  const bool all = process::run_jobs(
      scenes.size(), [&](std::size_t k) { return judgements_text(judge_scene(question, scenes[k])); },
      [&](std::size_t k, const process::JobResult& result) { done[k] = result; }, pool);
  if (!all) return cannot_finish("interrupted: " + std::to_string(done.size()) + " scenes were judged");
  for (const auto& [k, result] : done) {
    const std::string file = (*files)[k].string();
    if (!result.failure.empty()) {
      out.broken.push_back({file, "survives", broken(0, 0, "the program " + result.failure)});
      continue;
    }
    Result<Judged> judged = judgements_from(result.output);
    if (!judged.ok()) return judged.error();
    if (!judged->problem.empty()) return bad_input(file + ": " + judged->problem);
    for (std::size_t i = 0; i < judged->judgements.size(); ++i) {
      const Judgement& one = judged->judgements[i].second;
      out.relations[i].second.count(one, k);
      if (one.outcome == Outcome::kBroken) out.broken.push_back({file, judged->judgements[i].first, one});
    }
  }
  return out;
}

Json to_json(const CorpusResult& result) {
  Json json = {{"scenes", result.scenes}, {"relations", Json::object()}, {"broken", Json::array()}};
  for (const auto& [name, tally] : result.relations) json["relations"][name] = to_json(tally);
  for (const CorpusResult::Broken& one : result.broken) {
    json["broken"].push_back({{"file", one.file}, {"relation", one.relation}, {"found", to_json(one.judgement)}});
  }
  return json;
}

}  // namespace tumble::hunt
