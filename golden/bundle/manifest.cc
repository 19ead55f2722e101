#include "golden/bundle/manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "golden/bundle/sealed_text.h"
#include "golden/judge/case_json.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShardsMax = 10'000;

Json facts_json(const RunFacts& facts) {
  Json options = Json::object();
  for (const auto& [name, value] : facts.options) options[name] = value;
  return {{"program_hash", facts.program_hash},
          {"suite_hash", facts.suite_hash},
          {"engine_hash", facts.engine_hash},
          {"selected_hash", facts.selected_hash},
          {"options", options}};
}

Json merged_json(const std::vector<MergedShard>& shards) {
  Json json = Json::array();
  for (const MergedShard& one : shards) {
    json.push_back({{"shard", one.shard},
                    {"cases", one.cases},
                    {"canaries", one.canaries},
                    {"seconds", one.seconds},
                    {"machine", one.machine},
                    {"date", one.date}});
  }
  return json;
}

RunFacts facts_from(const Json& json) {
  const Json& one = json.at("facts");
  RunFacts facts{.program_hash = one.at("program_hash"),
                 .suite_hash = one.at("suite_hash"),
                 .engine_hash = one.value("engine_hash", ""),
                 .selected_hash = one.at("selected_hash"),
                 .options = {},
                 .canaries = json.at("all_canaries"),
                 .expected = json.at("expected"),
                 .merged = {}};
  for (const auto& [name, value] : one.at("options").items()) facts.options.emplace_back(name, value);
  for (const Json& row : json.at("merged")) {
    facts.merged.push_back(
        {row.at("shard"), row.at("cases"), row.at("canaries"), row.at("seconds"), row.at("machine"), row.at("date")});
  }
  return facts;
}

Manifest manifest_from(const Json& json) {
  Manifest manifest{.suite = json.at("suite"),
                    .shard = json.at("shard"),
                    .shards = json.at("shards"),
                    .assignment = json.at("assignment"),
                    .selected = json.at("selected"),
                    .run = provenance_from(json.at("run")),
                    .facts = facts_from(json),
                    .judged = json.at("judged"),
                    .canaries = json.at("canaries"),
                    .files = {}};
  for (const Json& file : json.at("files")) {
    manifest.files.push_back({file.at("path"), file.at("bytes"), file.at("hash")});
  }
  return manifest;
}

/// Below the folder under any spelling: no "..", no root, no empty part.
bool stays_inside(const std::string& path) {
  const fs::path parts(path);
  return !path.empty() && parts.is_relative() && path.find('\0') == std::string::npos &&
         std::ranges::none_of(parts, [](const fs::path& part) { return part.empty() || part == ".." || part == "."; });
}

/// What is wrong with the numbers of a manifest; empty if nothing is.
std::string fault_of(const Manifest& manifest) {
  if (manifest.shards < 1 || manifest.shards > kShardsMax || manifest.shard < 1 || manifest.shard > manifest.shards) {
    return "found shard " + std::to_string(manifest.shard) + " of " + std::to_string(manifest.shards) +
           ", wanted 1 … N of at most " + std::to_string(kShardsMax);
  }
  for (const BundleFile& file : manifest.files) {
    if (!stays_inside(file.path)) return "names the file " + in_quotes(file.path) + ", wanted one below its folder";
  }
  return "";
}

Result<Manifest> parse(const std::string& text, const std::string& file) {
  const std::string again = "; run that shard again";
  const auto damaged = [&](const std::string& how) {
    return Error{ErrorKind::kDamaged, file + ": damaged: " + how + again};
  };
  if (const std::string fault = fault_of_seal(text); !fault.empty()) return damaged(fault);
  try {
    const Json json = Json::parse(text);
    if (const Json& format = json.at("format"); format != kBundleFormat) {
      return bad_input(file + ": found format " + format.dump() + ", wanted " + std::to_string(kBundleFormat) +
                       "; merge with the program that ran the shards");
    }
    Manifest manifest = manifest_from(json);
    if (const std::string fault = fault_of(manifest); !fault.empty()) return damaged(fault);
    return manifest;
  } catch (const Json::exception& problem) {
    return damaged(problem.what());
  }
}

}  // namespace

std::string manifest_text(const Manifest& manifest) {
  Json json = {{"format", kBundleFormat},
               {"shard", manifest.shard},
               {"shards", manifest.shards},
               {"assignment", manifest.assignment},
               {"suite", manifest.suite},
               {"selected", manifest.selected},
               {"run", to_json(manifest.run)},
               {"facts", facts_json(manifest.facts)},
               {"expected", manifest.facts.expected},
               {"judged", manifest.judged},
               {"canaries", manifest.canaries},
               {"all_canaries", manifest.facts.canaries},
               {"merged", merged_json(manifest.facts.merged)},
               {"files", Json::array()}};
  for (const BundleFile& file : manifest.files) {
    json["files"].push_back({{"path", file.path}, {"bytes", file.bytes}, {"hash", file.hash}});
  }
  return sealed(json.dump(1, ' ', false, Json::error_handler_t::replace));
}

Result<Manifest> read_manifest(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return bad_input(folder.string() + ": no such folder");
  const fs::path file = folder / kBundleFile;
  if (!fs::exists(fs::symlink_status(file, error))) {
    return bad_input(folder.string() + ": holds no " + kBundleFile +
                     ", wanted the --report of a shard that came to its end; run that shard again");
  }
  if (!fs::is_regular_file(fs::symlink_status(file, error))) {
    return bad_input(file.string() + ": is a link or no file, wanted the file that the shard wrote");
  }
  const Result<std::string> text = read_text(file);
  if (!text.ok()) return text.error();
  return parse(*text, file.string());
}

}  // namespace tumble::golden
