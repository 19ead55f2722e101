#include "tools/arguments/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string_view>

#include "src/base/text.h"
#include "tools/arguments/numbers.h"

namespace tumble::tools {
namespace {

constexpr std::uint64_t kThreadsMax = 256;
constexpr std::size_t kNameColumns = 28;
constexpr std::size_t kTextColumns = 72;

/// Help as one reads it: "--seconds S" without what it excludes and needs, descriptions broken before column 100.
class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat() {
    column_width(kNameColumns);
    label("Positionals", "Arguments");
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string type = option->get_type_name();
    return type.empty() ? "" : ' ' + type;
  }

  std::string make_option_desc(const CLI::Option* option) const override {
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
};

// "; found -x.tumble, which is no option; …" where a word, as the name of a file, begins like a short option.
std::string is_like_an_option(const CLI::App& app, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    constexpr std::string_view kOfNoFile = "-.0123456789";  // another option, or a number below 0
    if (word.size() < 2 || word[0] != '-' || kOfNoFile.find(word[1]) != std::string_view::npos) continue;
    const bool known = std::ranges::any_of(app.get_options(), [&](const CLI::Option* option) {
      return std::ranges::find(option->get_snames(), std::string(1, word[1])) != option->get_snames().end();
    });
    if (!known)
      return "; found " + in_quotes(word) + ", which is no option; wanted ./" + word + " for a file of that name";
  }
  return "";
}

// "; did you mean --seconds?" where a word begins like an option and is none.
std::string suggestion(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || name == "--" || std::ranges::find(names, name) != names.end()) continue;
    const std::string_view nearest = nearest_word(name, candidates);
    if (!nearest.empty()) return "; did you mean " + std::string(nearest) + "?";
  }
  return is_like_an_option(app, words);
}

// An empty variable of a script must not pass for an option that was not given.
std::string names_something(const std::string& text) {
  return text.empty() ? found_wanted(in_quotes(text), "a value; leave the option out where there is none") : "";
}

/// "-o", "--output" or "LOG": the first of the names under which help lists an argument.
std::string first_name(const CLI::Option& option) {
  if (!option.get_snames().empty()) return '-' + option.get_snames().front();
  return option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
}

CLI::ValidationError wrong(const std::string& name, const std::string& found, const std::string& wanted) {
  return CLI::ValidationError(name, found_wanted(in_quotes(found), wanted));
}

}  // namespace

Argument Argument::required() const {
  option_->required();
  return *this;
}

Argument Argument::excludes(Argument other) const {
  option_->excludes(other.option_);
  return *this;
}

Argument Argument::needs(Argument other) const {
  option_->needs(other.option_);
  return *this;
}

Argument Argument::offers(std::vector<std::string> words) const {
  (*words_)[first_name(*option_)] = std::move(words);
  return *this;
}

Arguments::Arguments(const std::string& command, const std::string& summary)
    : app_(std::make_unique<CLI::App>(summary, command)) {
  app_->formatter(std::make_shared<HelpFormat>());
  app_->set_help_flag("-h,--help", "Print this help and exit");
}

Arguments::~Arguments() = default;

Argument Arguments::positional(const std::string& name, std::string& target, const std::string& description) {
  return Argument(app_->add_option(name, target, description)->type_name(""), words_);
}

Argument Arguments::positional(const std::string& name, std::string& target,
                               const std::vector<std::string_view>& words) {
  words_[name] = {words.begin(), words.end()};
  const std::string wanted = list_text(words);
  const auto check = [known = words_[name], wanted](const std::string& text) {
    return std::ranges::find(known, text) == known.end() ? found_wanted(in_quotes(text), wanted) : "";
  };
  return Argument(app_->add_option(name, target, wanted)->type_name("")->check(check), words_);
}

Argument Arguments::positionals(const std::string& name, std::vector<std::string>& target,
                                const std::string& description) {
  return Argument(app_->add_option(name, target, description)->type_name(""), words_);
}

Argument Arguments::option(const std::string& names, const std::string& sign, std::string& target,
                           const std::string& description) {
  return Argument(app_->add_option(names, target, description)->type_name(sign)->check(names_something), words_);
}

Argument Arguments::option(const std::string& names, const std::string& sign, std::vector<std::string>& target,
                           const std::string& description) {
  return Argument(
      app_->add_option(names, target, description)->type_name(sign)->allow_extra_args(false)->check(names_something),
      words_);
}

Argument Arguments::whole(const std::string& name, const std::string& sign, std::optional<std::uint64_t>& target,
                          std::uint64_t low, std::uint64_t high, const std::string& description) {
  const auto read = [&target, name, low, high](const std::string& text) {
    target = parse_whole(text);
    if (target && *target >= low && *target <= high) return;
    throw wrong(name, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  };
  return Argument(app_->add_option_function<std::string>(name, read, description)->type_name(sign), words_);
}

Argument Arguments::positive(const std::string& name, const std::string& sign, std::optional<double>& target,
                             double high, const std::string& description) {
  const auto read = [&target, name, high](const std::string& text) {
    target = parse_number(text);
    if (target && *target > 0 && *target <= high) return;
    throw wrong(name, text, "a number above 0, at most " + number_text(high));
  };
  return Argument(app_->add_option_function<std::string>(name, read, description)->type_name(sign), words_);
}

Argument Arguments::flag(const std::string& name, bool& target, const std::string& description) {
  return Argument(app_->add_flag(name, target, description), words_);
}

Argument Arguments::json(bool& target) { return flag("--json", target, "Print JSON to standard output"); }

Argument Arguments::threads(std::optional<std::uint64_t>& target) {
  return whole("--threads", "N", target, 1, kThreadsMax, "Threads to step with; the result does not depend on it");
}

void Arguments::footer(const std::string& text) { app_->footer(text); }

std::vector<ArgumentText> Arguments::listed() const {
  std::vector<ArgumentText> arguments;
  for (const CLI::Option* option : app_->get_options()) {
    ArgumentText text;
    for (const std::string& name : option->get_snames()) text.names.push_back('-' + name);
    for (const std::string& name : option->get_lnames()) text.names.push_back("--" + name);
    if (text.names.empty()) text.names.push_back(option->get_name());
    text.sign = option->get_type_name();
    text.description = option->get_description();
    text.required = option->get_required();
    text.repeats = option->get_items_expected_max() > 1;
    if (const auto words = words_.find(first_name(*option)); words != words_.end()) text.words = words->second;
    arguments.push_back(std::move(text));
  }
  return arguments;
}

std::string Arguments::summary() const { return app_->get_description(); }

std::string Arguments::footer() const { return app_->get_footer(); }

Reading Arguments::read(const std::vector<std::string>& words) {
  try {
    app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));  // last word first, as CLI11 wants
    return {};
  } catch (const CLI::CallForHelp&) {  // CLI11 reports through exceptions; they end here
    return {Reading::Kind::kHelp, app_->help()};
  } catch (const CLI::ParseError& error) {
    return {Reading::Kind::kWrong, error.what() + suggestion(*app_, words)};
  }
}

}  // namespace tumble::tools
