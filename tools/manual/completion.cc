#include "tools/manual/completion.h"

#include <algorithm>

#include "src/base/text.h"

namespace tumble::tools {
namespace {

std::string command_names(const std::vector<ManualEntry>& commands) {
  std::string names;
  for (const ManualEntry& command : commands) names += command.name + ' ';
  return names + "help";
}

std::string option_names(const ManualEntry& command) {
  std::string names;
  for (const ArgumentText& argument : command.arguments) {
    if (argument.positional()) continue;
    for (const std::string& name : argument.names) names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

/// The words of which a command's first argument is one; empty where any file may stand there.
std::string words_of(const ManualEntry& command) {
  const auto positional = std::ranges::find_if(command.arguments, &ArgumentText::positional);
  return positional == command.arguments.end() ? "" : joined(positional->words, " ");
}

/// Whether it is an option whose values are among a few words.
bool has_words(const ArgumentText& argument) { return !argument.positional() && !argument.words.empty(); }

// Text inside single quotes of a shell; zsh also reads colons and brackets in it.
std::string single_quoted(const std::string& text, bool for_zsh) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else if (for_zsh && (c == ':' || c == '[' || c == ']' || c == '\\')) {
      out += '\\';
      out += c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string for_bash(const std::vector<ManualEntry>& commands) {
  std::string text =
      "# bash completion of tumble\n"
      "_tumble() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} options=\"\" words=\"\" "
      "values=\"\"\n"
      "  if [[ $word == = ]]; then\n"
      "    word=\"\"\n"
      "  elif [[ $before == = ]]; then\n"
      "    before=${COMP_WORDS[COMP_CWORD - 2]}\n"
      "  fi\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)) || { ((COMP_CWORD == 2)) && [[ ${COMP_WORDS[1]} == help ]]; }; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W '" +
      command_names(commands) +
      " --version --help' -- \"$word\")\n"
      "    return\n"
      "  elif [[ ${COMP_WORDS[1]} == help && ${COMP_WORDS[2]} == --completion ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W '" +
      joined({std::begin(kShells), std::end(kShells)}, " ") +
      "' -- \"$word\")\n"
      "    return\n"
      "  fi\n"
      "  case ${COMP_WORDS[1]} in\n";
  for (const ManualEntry& command : commands) {
    text +=
        "    " + command.name + ")\n      options='" + option_names(command) + "' words='" + words_of(command) + "'\n";
    if (std::ranges::any_of(command.arguments, has_words)) {
      text += "      case $before in\n";
      for (const ArgumentText& option : command.arguments) {
        if (has_words(option))
          text += "        " + joined(option.names, "|") + ") values='" + joined(option.words, " ") + "' ;;\n";
      }
      text += "      esac\n";
    }
    text += "      ;;\n";
  }
  return text +
         "  esac\n"
         "  if [[ -n $values ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$values\" -- \"$word\")\n"
         "    [[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace 2> /dev/null\n"
         "  elif [[ $word == -* ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\")\n"
         "  elif ((COMP_CWORD == 2)); then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
         "  fi\n"
         "}\n"
         "complete -o bashdefault -o default -F _tumble tumble\n";
}

std::string zsh_argument(const ArgumentText& argument) {
  if (argument.positional() && !argument.words.empty()) {
    return "':" + argument.names.front() + ":(" + joined(argument.words, " ") + ")'";
  }
  if (argument.positional()) return std::string("'") + (argument.repeats ? "*" : "") + ":file:_files'";
  const std::string help = '[' + single_quoted(argument.description, true) + ']';
  const std::string action =
      argument.words.empty() ? ":_files" : ":(" + single_quoted(joined(argument.words, " "), true) + ")";
  const std::string value = argument.sign.empty() ? "" : ':' + single_quoted(argument.sign, true) + action;
  std::string text;
  for (const std::string& name : argument.names) {
    if (!text.empty()) text += ' ';
    text.append(argument.repeats ? "'*" : "'").append(name).append(help).append(value).append("'");
  }
  return text;
}

std::string for_zsh(const std::vector<ManualEntry>& commands) {
  std::string text =
      "#compdef tumble\n"
      "local -a commands=(\n";
  for (const ManualEntry& command : commands) {
    text += "  '" + command.name + ':' + single_quoted(command.summary, true) + "'\n";
  }
  text +=
      "  'help:explain a command, with examples'\n"
      ")\n"
      "if ((CURRENT == 2)) || [[ $words[2] == help ]]; then\n"
      "  _describe command commands\n"
      "  return\n"
      "fi\n"
      "local name=$words[2]\n"
      "shift words\n"
      "((CURRENT--))\n"
      "case $name in\n";
  for (const ManualEntry& command : commands) {
    text += "  " + command.name + ") _arguments";
    for (const ArgumentText& argument : command.arguments) text += " \\\n    " + zsh_argument(argument);
    text += " ;;\n";
  }
  return text + "esac\n";
}

std::string for_fish(const std::vector<ManualEntry>& commands) {
  std::string text = "# fish completion of tumble\n";
  for (const ManualEntry& command : commands) {
    text += "complete -c tumble -n __fish_use_subcommand -f -a " + command.name + " -d '" +
            single_quoted(command.summary, false) + "'\n";
    if (const std::string words = words_of(command); !words.empty()) {
      text += "complete -c tumble -n '__fish_seen_subcommand_from " + command.name + "' -f -a '" + words + "'\n";
    }
    for (const ArgumentText& argument : command.arguments) {
      if (argument.positional()) continue;
      text += "complete -c tumble -n '__fish_seen_subcommand_from " + command.name + "'";
      for (const std::string& name : argument.names) {
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      text += argument.words.empty() ? "" : " -x -a '" + joined(argument.words, " ") + "'";
      text += (argument.sign.empty() || has_words(argument) ? "" : " -r") +
              (" -d '" + single_quoted(argument.description, false)) + "'\n";
    }
  }
  return text + "complete -c tumble -n __fish_use_subcommand -f -a help -d 'explain a command, with examples'\n";
}

}  // namespace

Result<std::string> completion(const std::vector<ManualEntry>& commands, const std::string& shell) {
  if (shell == "bash") return for_bash(commands);
  if (shell == "zsh") return for_zsh(commands);
  if (shell == "fish") return for_fish(commands);
  return bad_input(found_wanted(in_quotes(shell), "bash, zsh or fish"));
}

}  // namespace tumble::tools
