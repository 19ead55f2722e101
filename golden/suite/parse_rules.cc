#include "golden/suite/parse_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "golden/suite/metric_values.h"
#include "golden/suite/read_laws.h"
#include "golden/suite/text_files.h"
#include "replay/format/limits.h"
#include "replay/measure/channel_metrics.h"
#include "replay/measure/metric_bound.h"
#include "replay/measure/parting.h"
#include "src/base/check.h"
#include "src/scenes/parse_toml.h"
#include "src/scenes/table_reader.h"
#include "tumble/render/image.h"
#include "tumble/sim/limits.h"

namespace tumble::golden {
namespace {

using scenes::Problem;
using scenes::TableReader;

constexpr scenes::NumberRule kAnyNumber = {"a number", -std::numeric_limits<double>::max(),
                                           std::numeric_limits<double>::max(), ""};
constexpr scenes::IntegerRule kStepRule = {"a step", 0, sim::kStepsMax};
constexpr scenes::IntegerRule kEdgeRule = {"pixels", render::kSizeMin, render::kSizeMax};
constexpr scenes::IntegerRule kPixelRule = {"a number of pixels", 0,
                                            std::uint64_t{render::kSizeMax} * render::kSizeMax};
constexpr std::size_t kTextLengthMax = 1000;
constexpr std::size_t kFilesMax = 1000;
constexpr scenes::IntegerRule kRepeatRule = {"a number of runs", 1, 100};
constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};

std::optional<double> optional_number(TableReader& reader, std::string_view key) {
  if (!reader.has(key)) return std::nullopt;
  return reader.required_number(key, kAnyNumber);
}

/// A text, or a list of ids, which becomes one.
std::string read_bodies(TableReader& reader, const toml::table& table) {
  const toml::array* list = reader.has("bodies") ? table["bodies"].as_array() : nullptr;
  if (list == nullptr) return reader.text("bodies", "all", kTextLengthMax);
  std::string text;
  for (const toml::node& node : *list) {
    const auto id = node.value<std::int64_t>();
    if (!id || *id < 1) {
      reader.fail("bodies", "a text, or a list of ids");
      return "all";
    }
    text += (text.empty() ? "" : ",") + std::to_string(*id);
  }
  if (text.empty()) reader.fail("bodies", "at least one id");
  return text;
}

/// "channel.NAME.max" or "parting_time.D", where that is the name of a metric.
std::string made_metric_in(const toml::table& table) {
  const std::string name = table["name"].value_or(std::string());
  return replay::parse_channel_metric(name) || replay::parse_parting_metric(name) ? name : "";
}

/// The other session of parting_time, a log in the case's folder.
void read_against(TableReader& reader, MetricRule& rule) {
  rule.against = reader.text("against", "", kTextLengthMax);
  const bool is_parting = replay::parse_parting_metric(rule.name).has_value();
  if (is_parting && rule.against.empty()) {
    reader.fail("against", "the log of the other session, a path from the case's folder");
  }
  if (is_parting && (rule.bodies != "all" || rule.from_step != 0)) {
    reader.fail(rule.from_step != 0 ? "from_step" : "bodies", "no such key: parting_time.D is of all bodies and steps");
  }
  if (!is_parting && !rule.against.empty()) {
    reader.fail("against", "no such key: only parting_time.D compares with another session");
  }
}

MetricRule read_metric(TableReader& reader, const toml::table& table, bool is_external) {
  MetricRule rule;
  const std::vector<const char*> names = metric_names();
  const std::string made = made_metric_in(table);
  const std::size_t chosen = made.empty() ? reader.choice("name", names.size(), names) : names.size();
  if (!made.empty()) {
    rule.name = reader.text("name", "", 2 * replay::kColumnNameBytesMax);
  } else if (chosen < names.size()) {
    rule.name = names[chosen];
  } else {
    reader.fail("name", "the name of a metric of docs/metrics.md");
  }
  rule.min = optional_number(reader, "min");
  rule.max = optional_number(reader, "max");
  if (!rule.min && !rule.max) reader.fail("max", "a bound: max, min or both");
  if (rule.min && rule.max && *rule.min > *rule.max) reader.fail("min", "a number no larger than max");
  if (replay::judges_nothing(rule.name, rule.min, rule.max)) {
    reader.fail(rule.max ? "max" : "min", "a bound that can fail: this one holds for every session and judges nothing");
  }
  rule.value = optional_number(reader, "value");
  rule.why = reader.text("why", "", kTextLengthMax);
  if (rule.why.find_first_not_of(' ') == std::string::npos) reader.fail("why", "the reason for the bound");
  rule.may_be_null = reader.flag("may_be_null", false);
  rule.bodies = read_bodies(reader, table);
  rule.has_axis = reader.has("axis");
  rule.axis = kAxes[reader.choice("axis", 0, kAxes)];
  if (rule.axis == "z" && !is_external) reader.fail("axis", "x or y: z points up");
  rule.from_step = reader.integer("from_step", 0, kStepRule);
  read_against(reader, rule);
  if (const Status selection = check_selection(rule); !is_external && !selection.ok()) {  // which may name bodies
    reader.problem().report(reader.place("bodies"), reader.label() + ": " + selection.error().message);
  }
  if (const toml::node* node = table.get("name")) rule.line = node->source().begin.line;
  if (const toml::node* node = table.get("value")) rule.value_line = node->source().begin.line;
  reader.finish();
  return rule;
}

PictureRule read_picture(TableReader& reader) {
  PictureRule rule;
  rule.step = reader.integer("step", 0, kStepRule);
  rule.width = static_cast<int>(reader.integer("width", 320, kEdgeRule));
  rule.height = static_cast<int>(reader.integer("height", 240, kEdgeRule));
  rule.freezing = reader.flag("freezing", false);
  rule.far_off_max = reader.integer("far_off_max", 0, kPixelRule);
  if (rule.far_off_max >= static_cast<std::uint64_t>(rule.width) * static_cast<std::uint64_t>(rule.height)) {
    reader.fail("far_off_max", "fewer pixels than the picture has: this bound holds for every picture");
  }
  rule.why = reader.text("why", "", kTextLengthMax);
  if (rule.why.find_first_not_of(' ') == std::string::npos) reader.fail("why", "the reason for the bound");
  reader.finish();
  return rule;
}

std::vector<VerdictKind> read_require(TableReader& top, const toml::table& root) {
  std::vector<VerdictKind> require = CaseRules().require;
  if (!top.has("require")) return require;
  require.clear();
  const toml::array* list = root["require"].as_array();
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    const Result<VerdictKind> kind = parse_verdict(list->get(i)->value_or(std::string_view()));
    if (!kind.ok()) break;
    require.push_back(*kind);
  }
  if (list == nullptr || list->empty() || require.size() != list->size()) {
    top.fail("require", R"(a list of "exact", "behaviour" and "image", not empty)");
  }
  return require;
}

std::string read_command(TableReader& top) {
  const toml::table* table = top.table("command");
  if (table == nullptr) return "";
  TableReader reader(*table, "[command]", top.problem());
  std::string run = reader.text("run", "", kTextLengthMax);
  for (const char* part : {"{scene}", "{log}"}) {
    if (run.find(part) == std::string::npos) reader.fail("run", "a command line with {scene} and {log} in it");
  }
  reader.finish();
  return run;
}

std::vector<std::string> read_files(TableReader& reader, const toml::table& table) {
  std::vector<std::string> files;
  if (!reader.has("files")) return files;
  const toml::array* list = table["files"].as_array();
  for (std::size_t i = 0; list != nullptr && i < list->size() && i < kFilesMax; ++i) {
    files.push_back(list->get(i)->value_or(std::string()));
    if (files.back().empty() || !list->get(i)->is_string()) list = nullptr;
  }
  if (list == nullptr || list->empty() || list->size() > kFilesMax) {
    reader.fail("files", "a list of names of files, relative to the case's folder");
  }
  return files;
}

std::optional<EngineCase> read_engine(TableReader& top) {
  const toml::table* table = top.table("engine");
  if (table == nullptr) return std::nullopt;
  TableReader reader(*table, "[engine]", top.problem());
  EngineCase engine;
  engine.title = reader.text("title", "", kTextLengthMax);
  engine.category = reader.text("category", "", kTextLengthMax);
  engine.scene = reader.text("scene", "", kTextLengthMax);
  engine.inputs = reader.text("inputs", "", kTextLengthMax);
  engine.files = read_files(reader, *table);
  engine.repeat = reader.integer("repeat", 1, kRepeatRule);
  if (engine.all_files().empty()) {
    reader.fail("files", R"(its input files: scene, inputs, or files = ["setup.txt"], a text of what is compiled in)");
  }
  reader.finish();
  return engine;
}

Result<CaseRules> parse(std::string_view text, std::string_view file_name) {
  Problem problem(file_name);
  const std::optional<toml::table> root = scenes::parse_toml(text, "", problem);
  if (!root) return problem.error();
  TableReader top(*root, "", problem);
  CaseRules rules;
  rules.require = read_require(top, *root);
  rules.command = read_command(top);
  rules.engine = read_engine(top);
  if (rules.engine && !rules.command.empty()) {
    top.fail("command", "either [command], which runs its own command, or [engine], which runs that of tumble.toml");
  }
  if (const toml::array* metrics = top.array_of_tables("metric")) {
    for (const toml::node& node : *metrics) {
      TableReader reader(*node.as_table(), "[[metric]]", problem);
      rules.metrics.push_back(read_metric(reader, *node.as_table(), rules.is_external()));
    }
  }
  rules.laws = read_laws(top);
  if (const toml::array* pictures = top.array_of_tables("picture")) {
    for (const toml::node& node : *pictures) {
      TableReader reader(*node.as_table(), "[[picture]]", problem);
      rules.pictures.push_back(read_picture(reader));
    }
  }
  for (const MetricRule& rule : rules.metrics) {
    const bool is_new = !rule.against.empty() && rules.engine &&
                        std::ranges::find(rules.engine->files, rule.against) == rules.engine->files.end();
    if (is_new) rules.engine->files.push_back(rule.against);
  }
  if (rules.metrics.empty()) top.fail("metric", "at least one [[metric]]: a case that measures nothing proves nothing");
  top.finish();
  if (problem.found()) return problem.error();
  return rules;
}

/// "value = 0.5  # comment" with another value; empty if the line is not of that form.
std::string replaced_value(const std::string& line, const std::string& value) {
  const std::size_t equals = line.find('=');
  const std::size_t key = line.find_first_not_of(' ');
  if (equals == std::string::npos || line.compare(key, 5, "value") != 0) return "";
  const std::size_t from = line.find_first_not_of(' ', equals + 1);
  if (from == std::string::npos) return "";
  const std::size_t to = std::min(line.find_first_of(" #", from), line.size());
  return line.substr(0, from) + value + line.substr(to);
}

}  // namespace

Result<CaseRules> parse_rules(std::string_view text, std::string_view file_name) {
  try {
    return parse(text, file_name);
  } catch (const std::bad_alloc&) {
    return cannot_finish(std::string(file_name) + ": not enough memory");
  }
}

Result<CaseRules> read_rules(const std::filesystem::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text.ok()) return text.error();
  Result<CaseRules> rules = parse_rules(*text, file.string());
  if (!rules.ok()) return rules;
  for (MetricRule& rule : rules->metrics) {
    if (!rule.against.empty()) rule.against_path = (file.parent_path() / rule.against).string();
  }
  return rules;
}

Result<std::string> with_values(const std::string& text, const std::string& file_name, const CaseRules& rules,
                                const std::vector<std::optional<double>>& values) {
  SIM_CHECK(values.size() == rules.metrics.size(), values.size(), rules.metrics.size());
  std::vector<std::string> lines = lines_of(text);
  // Goes from the last metric to the first: an inserted line leaves the line numbers above it right.
  for (std::size_t k = rules.metrics.size(); k-- > 0;) {
    const MetricRule& rule = rules.metrics[k];
    const std::string number = values[k] ? number_text(*values[k]) : "";
    const std::size_t at = rule.value_line > 0 ? rule.value_line : rule.line;
    if (at == 0 || at > lines.size()) return bad_input(file_name + ": no line " + std::to_string(at));
    std::string& line = lines[at - 1];
    if (rule.value_line == 0) {
      if (line.starts_with("name")) {
        if (values[k]) lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), "value = " + number);
        continue;
      }
    } else if (!values[k]) {
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at - 1));
      continue;
    } else if (std::string replaced = replaced_value(line, number); !replaced.empty()) {
      line = std::move(replaced);
      continue;
    }
    return bad_input(
        file_name + ":" + std::to_string(at) + ": found " + in_quotes(line) +
        ", wanted each key of [[metric]] at the start of a line of its own, so that values can be written");
  }
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  const Result<CaseRules> again = parse_rules(out, file_name);
  if (!again.ok()) return again.error();
  return out;
}

}  // namespace tumble::golden
