#include "golden/bless/rewrite_scene.h"

#include <new>
#include <optional>
#include <sstream>

#include "src/scenes/overrides.h"
#include "src/scenes/parse_toml.h"

namespace tumble::golden {

Result<std::string> rewrite_scene(std::string_view toml_text, std::string_view file_name, std::string_view name,
                                  std::span<const std::string> overrides) {
  try {
    scenes::Problem problem(file_name);
    std::optional<toml::table> root = scenes::parse_toml(toml_text, "", problem);
    if (!root) return problem.error();
    const bool same_name = !root->contains("name") || (*root)["name"].value_or(std::string_view()) == name;
    if (overrides.empty() && same_name) return std::string(toml_text);
    for (const std::string& argument : overrides) {
      if (Status status = scenes::apply_override(*root, argument); !status.ok()) return status.error();
    }
    root->insert_or_assign("name", std::string(name));
    std::ostringstream out;
    out << toml::toml_formatter(*root) << '\n';
    return out.str();
  } catch (const std::bad_alloc&) {
    return cannot_finish(std::string(file_name) + ": not enough memory for this scene");
  }
}

}  // namespace tumble::golden
