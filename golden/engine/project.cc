#include "golden/engine/project.h"

#include <new>
#include <system_error>
#include <utility>

#include "golden/suite/text_files.h"
#include "src/process/split_words.h"
#include "src/scenes/parse_toml.h"
#include "src/scenes/table_reader.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;
using scenes::Problem;
using scenes::TableReader;

constexpr std::size_t kCommandLengthMax = 10'000;
constexpr std::size_t kTextsMax = 1000;
constexpr double kTimeoutMax = 1e6;
constexpr scenes::NumberRule kTimeoutRule = {"a time", 0, kTimeoutMax, "s"};
constexpr scenes::IntegerRule kSubstepsRule = {"a number of substeps", 1, 1000};

/// Whether a command line can be split, where no shell does that.
bool is_splittable(const std::string& command, bool shell) { return shell || process::split_words(command).ok(); }

/// One text, or a list of them, each of which `fits`.
template <class Fits>
std::vector<std::string> read_texts(TableReader& reader, const toml::table& table, const char* key, const char* wanted,
                                    const Fits& fits) {
  if (!reader.has(key)) return {};
  std::vector<std::string> texts;
  const toml::node& node = *table.get(key);
  const auto add = [&](const toml::node& one) {
    const auto text = one.value<std::string>();
    if (!text || !one.is_string() || text->size() > kCommandLengthMax || !fits(*text)) return false;
    texts.push_back(*text);
    return true;
  };
  bool is_right = node.is_string() ? add(node) : node.is_array();
  if (const toml::array* list = node.as_array()) {
    is_right = !list->empty() && list->size() <= kTextsMax;
    for (const toml::node& one : *list) is_right = is_right && add(one);
  }
  if (!is_right) reader.fail(key, wanted);
  return texts;
}

TableReading read_table(TableReader& engine) {
  TableReading reading;
  const toml::table* table = engine.table("table");
  if (table == nullptr) return reading;
  TableReader reader(*table, "[engine.table]", engine.problem());
  const auto holds = [](char sign) {
    return [sign](const std::string& text) { return text.find(sign) != std::string::npos; };
  };
  reading.map = read_texts(reader, *table, "map", "\"FIELD=COLUMN\" or a list of such texts", holds('='));
  reading.header = read_texts(reader, *table, "header", "\"key: value\" or a list of such texts", holds(':'));
  reading.map_file = reader.text("map_file", "", kCommandLengthMax);
  reading.model = reader.text("model", "", kCommandLengthMax);
  reading.scalar_last = reader.flag("scalar_last", false);
  reading.channels = reader.flag("channels", false);
  reader.finish();
  return reading;
}

void read_claims(TableReader& engine, EngineProject& project) {
  std::map<std::string, bool>& claims = project.claims;
  const toml::table* table = engine.table("claims");
  if (table == nullptr) return;
  TableReader reader(*table, "[engine.claims]", engine.problem());
  for (const auto& [key, value] : *table) {
    const auto claim = claims.emplace(key.str(), false).first;  // the reader keeps a view of the key
    claim->second = reader.required_flag(claim->first);
    const toml::source_position at = key.source().begin;
    project.claim_places[claim->first] = std::to_string(at.line) + ":" + std::to_string(at.column);
  }
  reader.finish();
}

std::string read_command(TableReader& reader, const char* key, bool shell) {
  std::string command = reader.text(key, "", kCommandLengthMax);
  if (!command.empty() && !is_splittable(command, shell)) reader.fail(key, "a command line with its quotes closed");
  return command;
}

EngineProject read_engine(TableReader& reader, const toml::table& table) {
  EngineProject project;
  project.shell = reader.flag("shell", false);
  project.build =
      read_texts(reader, table, "build",
                 "a command line or a list of them, each with its quotes closed, or no key where nothing is "
                 "to be built",
                 [&](const std::string& command) { return is_splittable(command, project.shell); });
  project.run = read_command(reader, "run", project.shell);
  if (project.run.find("{log}") == std::string::npos) {
    reader.fail("run", "a command line with {log} in it, the file that the engine has to write");
  }
  project.scene = reader.text("scene", "", kCommandLengthMax);
  project.timeout_s = reader.number("timeout", 0, kTimeoutRule);
  project.integrator = static_cast<Integrator>(reader.choice("integrator", 0, kIntegratorNames));
  project.substeps = reader.integer("substeps", 1, kSubstepsRule);
  project.table = read_table(reader);
  read_claims(reader, project);
  reader.finish();
  return project;
}

Result<EngineProject> parse(std::string_view text, const fs::path& file) {
  Problem problem(file.string());
  const std::optional<toml::table> root = scenes::parse_toml(text, "", problem);
  if (!root) return problem.error();
  TableReader top(*root, "", problem);
  EngineProject project;
  if (const toml::table* table = top.table("engine")) {
    TableReader reader(*table, "[engine]", problem);
    project = read_engine(reader, *table);
  } else {
    top.fail("engine", "a table [engine] with the key run");
  }
  top.finish();
  if (problem.found()) return problem.error();
  project.file = file;
  project.folder = file.parent_path();
  return project;
}

}  // namespace

Result<EngineProject> parse_project(std::string_view text, const fs::path& file) {
  try {
    return parse(text, file);
  } catch (const std::bad_alloc&) {
    return cannot_finish(file.string() + ": not enough memory");
  }
}

Result<EngineProject> read_project(const fs::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text.ok()) return text.error();
  std::error_code error;
  return parse_project(*text, fs::absolute(file, error).lexically_normal());
}

double fall_in_a_step(const EngineProject& project) {
  if (project.integrator == Integrator::kExact) return 1;
  const double part = 1 / static_cast<double>(project.substeps);
  return project.integrator == Integrator::kSemiImplicitEuler ? 1 + part : 1 - part;
}

Result<std::optional<EngineProject>> find_project(const fs::path& from) {
  std::error_code error;
  fs::path folder = fs::absolute(from, error).lexically_normal();
  for (;; folder = folder.parent_path()) {
    if (const fs::path file = folder / kProjectFile; fs::exists(file, error)) {
      Result<EngineProject> project = read_project(file);
      if (!project.ok()) return project.error();
      return std::optional<EngineProject>(*std::move(project));
    }
    if (folder == folder.parent_path()) return std::optional<EngineProject>();
  }
}

EngineProject project_of_command(const std::string& run, const fs::path& folder, bool shell) {
  EngineProject project;
  project.folder = folder;
  project.run = run;
  project.shell = shell;
  return project;
}

}  // namespace tumble::golden
