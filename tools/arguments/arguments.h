#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// The arguments of one command: declared, then read from the command line. CLI11 does the reading, and only
/// arguments.cc includes it: it costs ten seconds a file to compile.
namespace tumble::tools {

/// One declared argument; what holds between it and others. Valid as long as its Arguments.
class Argument {
 public:
  Argument required() const;                ///< a command line without it is an error
  Argument excludes(Argument other) const;  ///< both at once are an error
  Argument needs(Argument other) const;     ///< this one without the other is an error

  /// What a shell offers for the value of an option. A word that ends with '=' wants more behind it.
  Argument offers(std::vector<std::string> words) const;

 private:
  friend class Arguments;
  using WordsByName = std::map<std::string, std::vector<std::string>>;
  Argument(CLI::Option* option, WordsByName& words) : option_(option), words_(&words) {}

  CLI::Option* option_;
  WordsByName* words_;
};

/// The outcome of reading a command line.
struct Reading {
  enum class Kind { kRun, kHelp, kWrong };
  Kind kind = Kind::kRun;
  std::string text;  ///< kHelp: the help; kWrong: what was found and what is wanted
};

/// One declared argument, as help, a manual page and a shell's completion name it.
struct ArgumentText {
  std::vector<std::string> names;  ///< "-o", "--output"; one name without dashes: a positional
  std::string sign;                ///< what stands for the value, as in "FILE"; empty: takes none, or a positional
  std::string description;
  bool required = false;
  bool repeats = false;                 ///< may be given more than once
  std::vector<std::string> words = {};  ///< of a positional the only values, of an option usual ones; empty: any

  [[nodiscard]] bool positional() const { return !names.front().starts_with('-'); }
};

/// Each target gets its value when read() finds the argument, keeps its own where it is not given, and must outlive the
/// Arguments. Help lists arguments in the order of their declaration. `sign` stands for the value in help, as in
/// "FILE".
class Arguments {
 public:
  /// command: "tumble record"; summary: the first line of its help. Declares -h and --help.
  Arguments(const std::string& command, const std::string& summary);
  ~Arguments();

  Argument positional(const std::string& name, std::string& target, const std::string& description);

  /// One of these words, which are its description too.
  Argument positional(const std::string& name, std::string& target, const std::vector<std::string_view>& words);

  /// Takes every further word of the command line.
  Argument positionals(const std::string& name, std::vector<std::string>& target, const std::string& description);

  /// names: "--size", or "-o,--output"
  Argument option(const std::string& names, const std::string& sign, std::string& target,
                  const std::string& description);

  /// May be repeated: one value a time.
  Argument option(const std::string& names, const std::string& sign, std::vector<std::string>& target,
                  const std::string& description);

  /// A whole number low … high.
  Argument whole(const std::string& name, const std::string& sign, std::optional<std::uint64_t>& target,
                 std::uint64_t low, std::uint64_t high, const std::string& description);

  /// A number above 0, up to high.
  Argument positive(const std::string& name, const std::string& sign, std::optional<double>& target, double high,
                    const std::string& description);

  Argument flag(const std::string& name, bool& target, const std::string& description);

  Argument json(bool& target);                             ///< --json
  Argument threads(std::optional<std::uint64_t>& target);  ///< --threads, 1 … 256; results do not depend on it

  /// Sets the text that help prints after the list of arguments: examples, exit statuses.
  void footer(const std::string& text);

  /// All declared arguments in their order, and the texts before and after their list in help.
  [[nodiscard]] std::vector<ArgumentText> listed() const;
  [[nodiscard]] std::string summary() const;
  [[nodiscard]] std::string footer() const;

  /// words: those after the command's name, in their order. May be called once.
  Reading read(const std::vector<std::string>& words);

 private:
  std::unique_ptr<CLI::App> app_;
  Argument::WordsByName words_;  // of arguments with a few, by their names
};

}  // namespace tumble::tools
