// tumble hunt: judges random scenes by relations and laws, and shrinks those that break one.
#include "golden/hunt/hunt.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "golden/hunt/batch.h"
#include "golden/hunt/corpus.h"
#include "golden/hunt/judge/relation.h"
#include "golden/hunt/merge_hunts.h"
#include "golden/suite/temporary_folder.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/shard.h"
#include "tools/hunt/hunt_output.h"
#include "tools/hunt/other_program.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

constexpr std::uint64_t kNumberMax = 1'000'000'000'000;
constexpr std::uint64_t kHuntsAtOnceMax = 256;

struct HuntCommand {
  std::optional<std::uint64_t> seed, count, threads, print, shrink;
  std::optional<double> time;
  std::vector<std::string> relations, within;
  std::string against, shard;
  std::string folder, corpus, judge;
  bool engine = false;
  std::vector<std::string> merge;
  bool list = false;
  bool unshrunk = false;
  bool json = false;
};

std::vector<std::string> relation_words() {
  std::vector<std::string> words;
  for (const hunt::Relation& relation : hunt::relations()) words.emplace_back(relation.name);
  return words;
}

Result<Exit> print_scene(const HuntCommand& options) {
  const Result<hunt::TextScene> scene = hunt::drawn_scene(options.seed.value_or(1), *options.print);
  if (!scene.ok()) return scene.error();
  std::cout << scene->text;
  return Exit::kSame;
}

constexpr std::uint64_t kEngineTries = 600;  // scenes that an engine runs to shrink one

Result<hunt::HuntOptions> hunt_options(const HuntCommand& options) {
  hunt::HuntOptions out;
  if (options.engine) {
    Result<std::optional<golden::EngineProject>> project = golden::find_project(std::filesystem::current_path());
    if (!project.ok()) return project.error();
    if (!*project)
      return bad_input(
          "--engine: found no tumble.toml here or above, wanted one with [engine] (docs/other_engines.md)");
    out.question.engine = *std::move(*project);
    out.tries_most = kEngineTries;
  }
  out.seed = options.seed.value_or(1);
  out.count = options.count;
  out.seconds = options.time;
  out.question.only = options.relations;
  if (!options.against.empty()) {
    if (Status ok = check_other_program(options.against); !ok.ok()) return ok.error();
  }
  out.question.against = options.against;
  Result<std::vector<hunt::ApartBound>> within = hunt::read_bounds(options.within);
  if (!within.ok()) return within.error();
  if (!options.within.empty() && options.against.empty())
    return bad_input("--within: found no --against, wanted the build whose sessions are compared");
  out.question.within = *std::move(within);
  out.folder = options.folder;
  out.shrunk_most = options.unshrunk ? 0 : options.shrink.value_or(out.shrunk_most);
  out.corpus = options.corpus;
  out.pool.jobs = options.threads.value_or(std::max(1U, std::thread::hardware_concurrency()));
  out.pool.cancel = process::InterruptGuard::interrupted;
  return out;
}

Result<Exit> judge_folder(const HuntCommand& options) {
  if (const Status ok = golden::check_temporary_place(); !ok.ok()) return ok.error();
  const process::InterruptGuard guard;
  const Result<hunt::HuntOptions> how = hunt_options(options);
  if (!how.ok()) return how.error();
  const Result<hunt::CorpusResult> result = hunt::judge_corpus(options.judge, how->question, how->pool);
  if (!result.ok()) return result.error();
  options.json ? print_json("hunt", hunt::to_json(*result)) : print_corpus(*result);
  if (const std::string error = hunt::judges_error(*result); !error.empty()) return cannot_finish(printable(error));
  if (!hunt::claims_hold(*result)) return Exit::kDifference;
  if (hunt::nothing_judged(*result)) return cannot_finish(nothing_judged_text(*result));
  return Exit::kSame;
}

Result<Exit> merge_corpora(const HuntCommand& options) {
  Result<hunt::Corpus> corpus = hunt::Corpus::open(options.corpus);
  if (!corpus.ok()) return corpus.error();
  for (const std::string& other : options.merge) {
    const Result<std::size_t> added = corpus->merge(other);
    if (!added.ok()) return added.error();
    if (!options.json) std::cout << other << ": " << count_text(*added, "scene") << " added\n";
  }
  if (options.json) {
    print_json("hunt", {{"scenes", corpus->files().size()}, {"features", corpus->features()}});
  } else {
    std::cout << options.corpus << ": " << count_text(corpus->files().size(), "scene") << " with "
              << count_text(corpus->features().size(), "feature") << '\n';
  }
  return Exit::kSame;
}

// A shard that has no scene of the count is whole without one.
bool is_empty_shard(const HuntCommand& options, const hunt::HuntState& state) {
  return state.next == 0 && options.count && state.share.of(*options.count) == 0;
}

Result<Exit> tell(const HuntCommand& options, const hunt::HuntState& state) {
  if (options.json) {
    Json json = hunt::to_json(state);
    json["is_empty_shard"] = is_empty_shard(options, state);
    print_json("hunt", json);
  } else {
    print_hunt(state, options.folder);
  }
  if (const std::string error = hunt::judges_error(state); !error.empty()) return cannot_finish(printable(error));
  if (!claims_hold(state)) return Exit::kDifference;
  if (!nothing_judged(state)) return Exit::kSame;
  const std::string text = nothing_judged_text(state, options.count);
  if (!is_empty_shard(options, state)) return cannot_finish(text);
  if (!options.json) std::cout << text << '\n';
  return Exit::kSame;
}

Result<Exit> merge(const HuntCommand& options) {
  if (!options.corpus.empty() && !options.folder.empty()) {
    return bad_input("--merge: found both --corpus and --folder, wanted --corpus for corpora or --folder for shards");
  }
  if (!options.corpus.empty()) return merge_corpora(options);
  if (options.folder.empty()) {
    return bad_input(
        "--merge: found neither --corpus nor --folder, wanted --corpus for corpora or --folder for shards");
  }
  const Result<hunt::HuntState> sum = hunt::merge_hunts({options.merge.begin(), options.merge.end()}, options.folder);
  if (!sum.ok()) return sum.error();
  return tell(options, *sum);
}

Result<Exit> hunt_for(const HuntCommand& options) {
  if (const Status ok = golden::check_temporary_place(); !ok.ok()) return ok.error();
  if (options.list) {
    options.json ? print_json("hunt", relations_json()) : print_relations();
    return Exit::kSame;
  }
  if (options.print) return print_scene(options);
  if (!options.judge.empty()) return judge_folder(options);
  if (!options.merge.empty()) return merge(options);
  Result<hunt::HuntOptions> chosen = hunt_options(options);
  if (!chosen.ok()) return chosen.error();
  hunt::HuntOptions how = *std::move(chosen);
  const Result<Shard> shard = read_shard(options.shard);
  if (!shard.ok()) return shard.error();
  how.share = {shard->k, shard->n};
  const process::InterruptGuard guard;
  ProgressBar bar("hunting", !options.json);
  how.progress = [&](const hunt::HuntState& state) { bar.show(state.next, how.share.of(options.count.value_or(0))); };
  how.found = [&](const hunt::Finding& finding) {
    bar.finish();
    if (!options.json) print_finding(finding);
    std::cout.flush();
  };
  const Result<hunt::HuntState> state = hunt::hunt_scenes(how);
  bar.finish();
  if (!state.ok()) return state.error();
  Result<Exit> exit = tell(options, *state);
  if (process::InterruptGuard::interrupted())
    return cannot_finish("interrupted: " + std::to_string(state->next) + " scenes are judged" +
                         (options.folder.empty() ? "" : " and kept"));
  return exit;
}

void exclude_all(const Argument& argument, std::initializer_list<Argument> others) {
  for (const Argument& other : others) argument.excludes(other);
}

constexpr const char* kFooter =
    "Exit status: 0 no scene broke a relation, of an engine none that it claims, or no scene of --count is the\n"
    "shard's; 1 findings; 2 bad usage, a folder of another hunt, or a shard that is missing, there twice or not at "
    "its\n"
    "end; 3 a damaged folder or shard; 4 could not finish, judged nothing, was interrupted, or tumble's own judge\n"
    "ended over a scene; the folder then holds what was judged.\n\n"
    "Examples:\n"
    "  tumble hunt --time 600 --folder hunt\n"
    "  tumble hunt --seed 7 --count 1000 --relation energy --relation cone\n"
    "  tumble hunt --seed 7 --print 123 >scene.toml\n"
    "  tumble hunt --count 500 --against old/tumble\n"
    "  tumble hunt --count 500 --against old/tumble --within bounds --within overlap_peak=0.01+10%\n"
    "  tumble hunt --time 60 --corpus corpus && tumble hunt --judge corpus\n"
    "  tumble hunt --count 20000 --shard 1/4 --folder hunt-1\n"
    "  tumble hunt --merge hunt-1 --merge hunt-2 --merge hunt-3 --merge hunt-4 --folder hunt";

}  // namespace

Action declare_hunt(Arguments& arguments) {
  auto options = std::make_shared<HuntCommand>();
  const Argument seed = arguments.whole("--seed", "S", options->seed, 0, kNumberMax, "Of the scenes; 1 if not given");
  const Argument count =
      arguments.whole("--count", "N", options->count, 1, kNumberMax, "Judge scenes 0 to N - 1 of the seed");
  const Argument time =
      arguments.positive("--time", "T", options->time, 1e7, "Seconds to hunt; 60 if neither this nor --count is given");
  const Argument shard = arguments.option(
      "--shard", "K/N", options->shard,
      "Only the scenes whose number mod N is K - 1; auto: as the environment of the build system says");
  const Argument relation =
      arguments
          .option("--relation", "NAME", options->relations,
                  "Judge by this relation or law alone; may be repeated; all if not given. With --against "
                  "also by against and the bounds of --within, unless against or an against_METRIC is "
                  "named")
          .offers(relation_words());
  const Argument against =
      arguments.option("--against", "PROGRAM", options->against,
                       "Another build of tumble: every session must have the same bits there; it has 60 s a scene");
  const Argument within =
      arguments
          .option(
              "--within", "BOUND", options->within,
              "How far sessions of --against may be apart: bits (not at all, if not given), bounds (the usual "
              "bounds, which --relations lists), or METRIC=AMOUNT, as in gain_max=0.1, 5% or 0.1+5%; may be repeated")
          .offers({"bits", "bounds"});
  const Argument engine = arguments.flag(
      "--engine", options->engine,
      "Judge the engine of the nearest tumble.toml; what its [engine.claims] lacks is measured and no failure");
  exclude_all(engine, {against, within});
  const Argument folder = arguments.option("--folder", "DIR", options->folder,
                                           "Keep the hunt in this folder, and go on with the hunt that it holds");
  const Argument corpus = arguments.option("--corpus", "DIR", options->corpus,
                                           "Add scenes to this folder that do something none in it does");
  const Argument merge = arguments.option(
      "--merge", "DIR", options->merge,
      "Hunt nothing; add another corpus to that of --corpus, or with --folder merge the folders of all "
      "shards into it; may be repeated");
  const Argument judge =
      arguments.option("--judge", "DIR", options->judge, "Hunt nothing; judge the scenes DIR/*.toml");
  arguments.whole("--threads", "N", options->threads, 1, kHuntsAtOnceMax,
                  "Scenes judged at once, one for each processor if not given; what is found does not depend on it");
  const Argument print =
      arguments.whole("--print", "NUMBER", options->print, 0, kNumberMax, "Print the scene of this number and end");
  const Argument list = arguments.flag("--relations", options->list, "List the relations and laws and end");
  list.excludes(print);
  exclude_all(list, {against, within});
  exclude_all(print, {against, within});
  const Argument unshrunk =
      arguments.flag("--unshrunk", options->unshrunk, "Name findings by their numbers alone, without shrinking any");
  const Argument shrink = arguments.whole("--shrink", "N", options->shrink, 1, kNumberMax,
                                          "Shrink so many findings of each relation and phase; 3 if not given");
  shrink.excludes(unshrunk);
  // What would be left aside without a word.
  exclude_all(judge, {seed, count, time, shard, folder, corpus, merge, print, unshrunk, shrink});
  exclude_all(merge, {seed, count, time, shard, relation, against, within, engine, print, unshrunk, shrink});
  arguments.json(options->json);
  arguments.footer(kFooter);
  return [options] { return hunt_for(*options); };
}

}  // namespace tumble::tools
