#include "tests/support/history.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace tumble::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = R"(title = "one box"
category = "session"
[world]
method = "thesis"
dt = 0.016666666666666666
steps = 20
[[box]]
position = [0.0, 0.0, 2.0]
[camera]
position = [0.0, -8.0, 3.0]
target = [0.0, 0.0, 1.0]
)";

constexpr const char* kRules = R"([[metric]]
name = "lost"
max = 0
why = "it does not fall through"

[[picture]]
step = 20
why = "where it lies"
)";

/// builds: a file that gets a line for each build. bin/whole needs no file beside it.
std::string build(const std::string& builds) {
  return "set -e\n[ ! -e broken ] || { echo \"engine.c:7: not C\" >&2; exit 1; }\necho built >>'" + builds +
         "'\nmkdir -p bin\ncp engine.sh bin/tumble\ncp fault bin/fault\n"
         "sed \"s|^fault=.*|fault='$(cat fault)'|\" engine.sh >bin/whole\nchmod +x bin/whole\n";
}

/// The program: this build's, with the fault given to every session.
std::string engine(const std::string& interrupt, const std::string& unsteady) {
  const std::string tumble = TUMBLE_PROGRAM;
  return "#!/bin/sh\nhere=$(dirname \"$0\")\nfault=$(cat \"$here/fault\")\n"
         "if [ -e '" +
         interrupt + "' ]; then rm '" + interrupt +
         "'; kill -INT $PPID; sleep 20; fi\n"
         "if [ -e '" +
         unsteady + "' ]; then echo run >>'" + unsteady + "'; [ $(wc -l <'" + unsteady +
         "') != 6 ] || fault='--set box.1.velocity=[0.01,0.0,0.0]'; fi\n"
         "command=$1; shift\n"
         "case $command in\n"
         "  check) exec " +
         tumble +
         " check \"$@\" ;;\n"
         "  record) exec " +
         tumble +
         " record \"$@\" $fault ;;\n"
         "  replay) " +
         tumble +
         " record \"$here/../scene.toml\" -o \"$here/own.tumble\" --quiet $fault || exit 4\n"
         "    exec " +
         tumble +
         " diff \"$1\" \"$here/own.tumble\" --brief --json ;;\n"
         "esac\n";
}

/// One file of a commit, as git fast-import reads it.
std::string file(const std::string& mode, const std::string& path, const std::string& content) {
  return "M " + mode + " inline " + path + "\ndata " + std::to_string(content.size()) + '\n' + content + '\n';
}

void must(const std::string& command) { ASSERT_EQ(std::system(command.c_str()), 0) << command; }

std::string first_commit(const Workshop& shop, const HistoryPlan& plan) {
  std::string text = file("100644", "scene.toml", kScene) + file("100644", "build.sh", build(shop.path("builds"))) +
                     file("100755", "engine.sh", engine(shop.path("interrupt"), shop.path("unsteady"))) +
                     file("100644", "fault", "") + file("100644", ".gitignore", "bin/\n");
  if (!plan.with_case) return text;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shop.path("suite"))) {
    if (!entry.is_regular_file()) continue;
    const std::string path = fs::relative(entry.path(), shop.path("suite")).string();
    text += file("100644", "golden/" + path, shop.read("suite/" + path));
  }
  return text;
}

std::string moved_camera(std::string scene) {
  const std::string what = "position = [0.0, -8.0, 3.0]";
  return scene.replace(scene.find(what), what.size(), "position = [0.0, -7.0, 3.0]");
}

std::string stream_of(const Workshop& shop, const HistoryPlan& plan) {
  std::ostringstream out;
  for (std::size_t n = 1; n <= plan.commits; ++n) {
    const std::string subject = n == plan.fault ? "solve: a harmless clean-up" : "notes: entry " + std::to_string(n);
    out << "commit refs/heads/main\ncommitter A Person <person@example.org> " << 1700000000 + 3600 * n << " +0000\n"
        << "data " << subject.size() << '\n'
        << subject << '\n';
    if (n == 1) out << first_commit(shop, plan);
    if (n == plan.fault) {
      out << file("100644", "fault", "--set box.1.velocity=[0.01,0.0,0.0]\n");
      if (plan.with_case) out << file("100644", "golden/cases/look/scene.toml", moved_camera(kScene));
    }
    out << file("100644", "notes.txt", "entry " + std::to_string(n) + '\n');
    const bool is_broken = plan.broken.contains(n);
    if (is_broken) out << file("100644", "broken", "x\n");
    if (!is_broken && plan.broken.contains(n - 1)) out << "D broken\n";
  }
  return out.str();
}

}  // namespace

History::History(const Workshop& shop, const HistoryPlan& plan) : shop_(shop) {
  if (plan.with_case) {
    shop.write("suite/cases/look/scene.toml", kScene);
    shop.write("suite/cases/look/metrics.toml", kRules);
    const Outcome blessed = shop.run({"bless", "look", "--suite", "suite", "--reason", "a test"});
    EXPECT_EQ(blessed.exit, 0) << blessed.err;
  }
  shop.write("stream", stream_of(shop, plan));
  const std::string project = shop.path("project");
  must("git init --quiet --initial-branch=main '" + project + "'");
  must("git -C '" + project + "' fast-import --quiet <'" + shop.path("stream") + "'");
  must("git -C '" + project + "' reset --quiet --hard");
  std::istringstream lines(git("rev-list main"));
  for (std::string line; std::getline(lines, line);) commits_.push_back(line);
  EXPECT_EQ(commits_.size(), plan.commits);
  shop.write("scene.toml", kScene);
  const Outcome recorded = shop.run({"record", "scene.toml", "-o", "session.tumble", "--quiet"});
  EXPECT_EQ(recorded.exit, 0) << recorded.err;
}

std::string History::git(const std::string& arguments) const {
  const std::string out = shop_.path("git.out");
  must("git -C '" + shop_.path("project") + "' " + arguments + " >'" + out + "'");
  return shop_.read("git.out");
}

std::string History::commit(std::size_t n) const { return commits_.at(commits_.size() - n); }

Outcome History::bisect(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {"--good", commit(1), "--bad", "main", "--program", "bin/tumble"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return bisect_by(arguments);
}

Outcome History::bisect_by(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {"bisect", "--repo", "project", "--build", "sh build.sh", "--work", "work"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return shop_.run(arguments);
}

std::string History::footprint() const {
  std::string text;
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(shop_.path("project"))) {
    if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), shop_.path("")).string());
  }
  for (const std::string& name : names) text.append(name).append(1, '\n').append(shop_.read(name)).append(1, '\n');
  return text;
}

void History::answer_otherwise_once() const { shop_.write("unsteady", ""); }

void History::interrupt_next() const { shop_.write("interrupt", ""); }

}  // namespace tumble::test
