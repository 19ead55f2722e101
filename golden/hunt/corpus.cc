#include "golden/hunt/corpus.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "golden/hunt/batch.h"
#include "golden/hunt/judge/features.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
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
  if (error) return bad_input(folder.string() + ": cannot be read: " + error.message() + "; wanted a folder of scenes");
  std::ranges::sort(files);
  return files;
}

// Every file that is of no use in one error: a corpus is mended at once. A cut file is damage.
Error unusable(const fs::path& folder, std::size_t files, const std::vector<Error>& problems) {
  Error all = bad_input(folder.string() + ": " + std::to_string(problems.size()) + " of " + count_text(files, "file") +
                        " cannot be used; mend or remove what is named here:");
  for (const Error& one : problems) {
    if (one.kind == ErrorKind::kDamaged) all.kind = one.kind;
    all.message += "\n  " + one.message;
  }
  return all;
}

// The first half of a hash of the text: two corpora name one scene alike.
std::string name_of_text(const std::string& text) {
  Hasher hasher;
  hasher.add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  return to_string(hasher.digest()).substr(0, 16) + ".toml";
}

// A name that add() may have given: its file is whole, or was cut or changed.
bool is_named_by_text(const fs::path& file) {
  const std::string stem = file.stem().string();
  return stem.size() == 16 && stem.find_first_not_of("0123456789abcdef") == std::string::npos;
}

Result<TextScene> read_scene(const fs::path& file) {
  Result<std::string> text = golden::read_text(file);
  if (!text.ok()) return text.error();
  if (is_named_by_text(file) && name_of_text(*text) != file.filename().string())
    return damaged(file.string() + ": was cut or changed: its name is not the hash of its text");
  Result<sim::SceneDef> scene = scenes::parse_scene(*text, file.string());
  if (!scene.ok()) return scene.error();
  return TextScene{*std::move(text), *std::move(scene)};
}

Result<std::vector<TextScene>> read_scenes(const fs::path& folder, const std::vector<fs::path>& files) {
  std::vector<TextScene> scenes;
  std::vector<Error> problems;
  for (const fs::path& file : files) {
    Result<TextScene> scene = read_scene(file);
    if (!scene.ok()) {
      problems.push_back(scene.error());
    } else {
      scenes.push_back(*std::move(scene));
    }
  }
  if (!problems.empty()) return unusable(folder, files.size(), problems);
  return scenes;
}

// What each scene of a folder does.
Result<std::vector<std::vector<std::string>>> features_of_all(const fs::path& folder,
                                                              const std::vector<fs::path>& files,
                                                              const std::vector<TextScene>& scenes) {
  std::vector<std::vector<std::string>> features;
  std::vector<Error> problems;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Result<Trace> session = trace(scenes[k].scene);
    if (!session.ok()) problems.push_back(bad_input(files[k].string() + ": " + session.error().message));
    features.push_back(session.ok() ? features_of(*session) : std::vector<std::string>{});
  }
  if (!problems.empty()) return unusable(folder, files.size(), problems);
  return features;
}

}  // namespace

Result<Corpus> Corpus::open(const fs::path& folder) {
  Corpus corpus(folder);
  std::error_code error;
  if (!fs::exists(folder, error)) return corpus;
  Result<std::vector<fs::path>> files = scenes_in(folder);
  if (!files.ok()) return files.error();
  const Result<std::vector<TextScene>> scenes = read_scenes(folder, *files);
  if (!scenes.ok()) return scenes.error();
  const auto features = features_of_all(folder, *files, *scenes);
  if (!features.ok()) return features.error();
  for (const std::vector<std::string>& one : *features) corpus.features_.insert(one.begin(), one.end());
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
  const Result<std::vector<TextScene>> scenes = read_scenes(other, *files);
  if (!scenes.ok()) return scenes.error();
  const auto features = features_of_all(other, *files, *scenes);
  if (!features.ok()) return features.error();
  std::size_t added = 0;
  for (std::size_t k = 0; k < scenes->size(); ++k) {
    const Result<bool> fresh = add((*scenes)[k], (*features)[k]);
    if (!fresh.ok()) return fresh.error();
    if (*fresh) ++added;
  }
  return added;
}

Result<CorpusResult> judge_corpus(const fs::path& folder, const Question& question, const process::PoolOptions& pool) {
  if (Status ok = check_question(question); !ok.ok()) return ok.error();
  const Result<std::vector<fs::path>> files = scenes_in(folder);
  if (!files.ok()) return files.error();
  if (files->empty()) return bad_input(folder.string() + ": found no scene, wanted files NAME.toml");
  const Result<std::vector<TextScene>> read = read_scenes(folder, *files);
  if (!read.ok()) return read.error();
  const std::vector<TextScene>& scenes = *read;
  const golden::TemporaryFolder scratch("tumble-hunt");  // goes with this process, however those end that judge
  Question asked = question;
  asked.scratch = scratch.path();
  CorpusResult out;
  out.scenes = scenes.size();
  if (question.engine) out.engine = question.engine->run;
  for (const std::string& name : names_of(question)) {
    out.relations.emplace_back(name, Tally{});
    if (question.engine && is_claimed(question, name)) out.claimed.push_back(name);
  }
  std::map<std::size_t, process::JobResult> done;
  const auto told = [&](std::size_t k) { return scratch.path() / ("judging-" + std::to_string(k)); };
  const bool all = process::run_jobs(
      scenes.size(),
      [&](std::size_t k) {
        Question one = asked;
        one.told = told(k);
        return judgements_text(judge_scene(one, scenes[k]));
      },
      [&](std::size_t k, const process::JobResult& result) { done[k] = result; }, pool);
  if (!all) return cannot_finish("interrupted: " + std::to_string(done.size()) + " scenes were judged");
  std::vector<Error> problems;
  for (const auto& [k, result] : done) {
    const std::string file = (*files)[k].string();
    if (!result.failure.empty()) {
      const std::string judging = told_in(told(k));
      out.broken.push_back({file, kSurvives, ended(result.failure, judging, question.engine.has_value()), judging});
      continue;
    }
    Result<Judged> judged = judgements_from(result.output);
    if (!judged.ok()) return judged.error();
    if (judged->refused) {
      if (out.refused++ == 0) out.refusal = file + ": " + judged->problem;
      continue;
    }
    if (!judged->problem.empty()) problems.push_back(bad_input(file + ": " + judged->problem));
    for (std::size_t i = 0; i < judged->judgements.size(); ++i) {
      const Judgement& one = judged->judgements[i].second;
      out.relations[i].second.count(one, k);
      if (one.outcome == Outcome::kBroken) out.broken.push_back({file, judged->judgements[i].first, one});
    }
  }
  if (!problems.empty()) return unusable(folder, files->size(), problems);
  return out;
}

bool nothing_judged(const CorpusResult& result) {
  return nothing_judged(result.relations, result.engine, result.claimed);
}

std::string judges_error(const CorpusResult& result) {
  const auto at = std::ranges::find_if(result.broken, [&result](const CorpusResult::Broken& one) {
    return is_judges_error(one.relation, one.judging, result.engine);
  });
  return at == result.broken.end() ? "" : at->file + ": " + at->judgement.what + ": an error of tumble";
}

bool claims_hold(const CorpusResult& result) {
  return std::ranges::none_of(result.broken, [&result](const CorpusResult::Broken& one) {
    return is_failure(one.relation, result.engine, result.claimed);
  });
}

Json to_json(const CorpusResult& result) {
  Json json = {{"scenes", result.scenes}, {"refused", result.refused}};
  if (!result.engine.empty()) {
    json["engine"] = result.engine;
    json["claimed"] = result.claimed;
  }
  json["relations"] = Json::object();
  json["broken"] = Json::array();
  for (const auto& [name, tally] : result.relations) json["relations"][name] = to_json(tally);
  for (const CorpusResult::Broken& one : result.broken) {
    json["broken"].push_back({{"file", one.file}, {"relation", one.relation}, {"found", to_json(one.judgement)}});
    if (!one.judging.empty()) json["broken"].back()["judging"] = one.judging;
  }
  return json;
}

}  // namespace tumble::hunt
