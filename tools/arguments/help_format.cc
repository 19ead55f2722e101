#include "tools/arguments/help_format.h"

#include <sstream>

namespace tumble::tools {
namespace {

constexpr std::size_t kNameColumns = 28;
constexpr std::size_t kTextColumns = 72;

}  // namespace

HelpFormat::HelpFormat() {
  column_width(kNameColumns);
  label("Positionals", "Arguments");
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  const std::string type = option->get_type_name();
  return type.empty() ? "" : ' ' + type;
}

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  std::istringstream words(option->get_description());
  std::string text, word;
  std::size_t column = 0;
  while (words >> word) {
    if (column > 0 && column + 1 + word.size() > kTextColumns) {
      text += '\n';  // CLI11 indents what follows
      column = 0;
    } else if (column > 0) {
      text += ' ';
      ++column;
    }
    text += word;
    column += word.size();
  }
  return text;
}

}  // namespace tumble::tools
