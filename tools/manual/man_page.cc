#include "tools/manual/man_page.h"

#include <sstream>

namespace tumble::tools {
namespace {

// Text as troff prints it: a backslash and a leading dot are commands there, and a plain '-' may become a hyphen that
// nobody can paste into a shell.
std::string troff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
      out += c;
    }
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + troff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + troff(text) + "\\fR"; }

// No date: two builds of one commit give one page.
std::string title(const std::string& page, const std::string& version) {
  return ".TH " + page + " 1 \"\" \"tumble " + version + "\" \"User Commands\"\n";
}

std::string synopsis_of(const ArgumentText& argument) {
  std::string text;
  if (argument.positional()) {
    text = italic(argument.names.front()) + (argument.repeats ? "..." : "");
  } else {
    text = bold(argument.names.back()) + (argument.sign.empty() ? "" : ' ' + italic(argument.sign));
  }
  return argument.required ? text : '[' + text + ']';
}

std::string heading_of(const ArgumentText& argument) {
  if (argument.positional()) return italic(argument.names.front());
  std::string text;
  for (const std::string& name : argument.names) text += (text.empty() ? "" : ", ") + bold(name);
  return argument.sign.empty() ? text : text + ' ' + italic(argument.sign);
}

std::string listed(const std::vector<ArgumentText>& arguments, bool positional) {
  std::string text;
  for (const ArgumentText& argument : arguments) {
    if (argument.positional() != positional) continue;
    text += ".TP\n" + heading_of(argument) + '\n' + troff(argument.description) + '\n';
  }
  return text;
}

// A footer's paragraphs: those whose lines are indented keep their lines, "Examples:" becomes a section.
std::string footer_of(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text, line;
  bool verbatim = false;
  const auto begin = [&](bool as_is) {
    if (as_is != verbatim) text += as_is ? ".PP\n.nf\n" : ".fi\n.PP\n";
    verbatim = as_is;
  };
  while (std::getline(lines, line)) {
    if (line == "Examples:") {
      begin(false);
      text += ".SH EXAMPLES\n";
    } else if (line.empty()) {
      begin(false);
      text += ".PP\n";
    } else {
      begin(line.starts_with(' '));
      text += troff(line) + '\n';
    }
  }
  begin(false);
  return text;
}

}  // namespace

std::string man_page(const ManualEntry& command, const std::string& version) {
  const std::string page = "tumble-" + command.name;
  std::string text = title(page, version) + ".SH NAME\n" + troff(page) + " \\- " + troff(command.summary) +
                     "\n.nh\n.ad l\n.SH SYNOPSIS\n" + bold("tumble " + command.name);
  for (const bool positional : {true, false}) {
    for (const ArgumentText& argument : command.arguments) {
      if (argument.positional() == positional) text += '\n' + synopsis_of(argument);
    }
  }
  text += '\n';
  if (const std::string positionals = listed(command.arguments, true); !positionals.empty()) {
    text += ".SH ARGUMENTS\n" + positionals;
  }
  text += ".SH OPTIONS\n" + listed(command.arguments, false);
  if (!command.footer.empty()) {
    text += (command.footer.starts_with("Examples:") ? "" : ".SH NOTES\n") + footer_of(command.footer);
  }
  return text + ".SH SEE ALSO\n" + bold("tumble") + "(1)\n";
}

std::string man_page_of_program(const std::vector<ManualEntry>& commands, const std::string& version) {
  std::string text = title("tumble", version) +
                     ".SH NAME\ntumble \\- flight recorder and regression lab for physics engines\n.SH SYNOPSIS\n" +
                     bold("tumble") + ' ' + italic("COMMAND") + " [" + italic("OPTIONS") + "]\n.br\n" +
                     bold("tumble help") + ' ' + italic("COMMAND") + "\n.SH COMMANDS\n";
  for (const ManualEntry& command : commands) {
    text += ".TP\n" + bold("tumble-" + command.name) + "(1)\n" + troff(command.summary) + '\n';
  }
  return text +
         ".SH EXIT STATUS\n"
         ".TP\n0\nthe same, passed, or done\n"
         ".TP\n1\na difference or a regression was found\n"
         ".TP\n2\nbad usage or bad input\n"
         ".TP\n3\na file is damaged or torn; what could be saved was saved\n"
         ".TP\n4\nthe command could not finish: no memory, a full disk, a state that is not finite\n"
         ".SH EXAMPLES\n.nf\n"
         "tumble record brick_wall\ntumble replay brick_wall.tumble\n.fi\n";
}

}  // namespace tumble::tools
