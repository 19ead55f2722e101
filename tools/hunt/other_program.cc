#include "tools/hunt/other_program.h"

#include <filesystem>
#include <system_error>

#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/process/run_child.h"

namespace tumble::tools {
namespace {

constexpr double kStartPatience = 60;  // s

Status no_tumble(const std::string& program, const std::string& found) {
  return bad_input("--against: found " + in_quotes(program) + ", " + found + ", wanted another build of tumble");
}

// What the program's file is that keeps it from starting.
std::string why_no_start(const std::string& program, const std::string& error) {
  if (program.find('/') == std::string::npos) {
    std::error_code none;
    const bool here = std::filesystem::is_regular_file(program, none);
    return "which was looked for in PATH and cannot be started there" +
           (here ? "; the file of the current folder is ./" + program : std::string());
  }
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(program, failed);
  if (!std::filesystem::exists(status)) return "where there is no file";
  if (std::filesystem::is_directory(status)) return "a folder";
  using std::filesystem::perms;
  if ((status.permissions() & (perms::owner_exec | perms::group_exec | perms::others_exec)) == perms::none)
    return "a file that is not executable (chmod +x makes it so)";
  return "which does not start: " + error;
}

}  // namespace

Status check_other_program(const std::string& program) {
  if (program.empty()) return bad_input("--against: found an empty value, wanted another build of tumble");
  const golden::TemporaryFolder folder("tumble-against");
  if (folder.path().empty()) return cannot_finish("--against: no temporary folder could be made");
  process::Program child;
  child.words = {program, "--version"};
  child.out = (folder.path() / "out").string();
  child.err = "/dev/null";
  const Result<process::ChildEnd> end = process::run_child(child, kStartPatience);
  if (!end.ok()) return no_tumble(program, why_no_start(program, end.error().message));
  if (end->late) return no_tumble(program, "which gave no answer to --version in " + fixed(kStartPatience, 0) + " s");
  if (end->signal != 0) return no_tumble(program, "which crashed at --version: it " + end->text());
  const Result<std::string> said = golden::read_text(child.out);
  const std::string answer = said.ok() ? said->substr(0, said->find('\n')) : "";
  if (!end->well()) return no_tumble(program, "which " + end->text() + " at --version");
  if (answer.starts_with("tumble ")) return {};
  return no_tumble(program, "which answers --version with " + in_quotes(answer));
}

}  // namespace tumble::tools
