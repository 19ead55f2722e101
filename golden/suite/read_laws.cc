#include "golden/suite/read_laws.h"

#include "golden/hunt/judge/relation.h"

namespace tumble::golden {

std::vector<std::string> read_laws(scenes::TableReader& top) {
  std::vector<std::string> laws;
  const toml::table* table = top.table("laws");
  if (table == nullptr) return laws;
  scenes::TableReader reader(*table, "[laws]", top.problem());
  for (const hunt::Relation& one : hunt::relations()) {
    if (!reader.has(one.name)) continue;
    if (!reader.required_flag(one.name)) reader.fail(one.name, "true; leave out a law that the case need not hold");
    laws.emplace_back(one.name);
  }
  if (reader.has(kSurvivesLaw)) {
    if (!reader.required_flag(kSurvivesLaw)) reader.fail(kSurvivesLaw, "true; leave it out");
    laws.emplace_back(kSurvivesLaw);
  }
  for (const auto& [key, _] : *table) {
    if (!key.str().starts_with("against") || !reader.has(key.str())) continue;
    reader.fail(key.str(),
                "no such key: a case has no other build to compare with; a [[metric]] parting_time.D, with "
                "`against` = a log of the other build, compares with its session");
  }
  reader.finish();
  return laws;
}

}  // namespace tumble::golden
