#include "tests/trial/hostile_files.h"

#include <fstream>
#include <span>
#include <utility>

#include "tests/trial/hostile_logs.h"

namespace tumble::trial {
namespace {

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

class Folder {
 public:
  explicit Folder(std::string folder) : folder_(std::move(folder)) {}
  void add(const std::string& name, std::span<const std::byte> bytes) {
    paths_.push_back(folder_ + "/" + name);
    std::ofstream file(paths_.back(), std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    complete_ = complete_ && file.flush().good();
  }
  void add(const std::string& name, const std::string& text) { add(name, std::as_bytes(std::span(text))); }
  Result<std::vector<std::string>> paths() {
    if (!complete_) return cannot_finish(folder_ + ": a file cannot be written");
    return paths_;
  }

 private:
  std::string folder_;
  std::vector<std::string> paths_;
  bool complete_ = true;
};

void add_texts(Folder& folder) {
  constexpr std::size_t kMany = 1 << 18;
  folder.add("long_line.csv", repeated("9", kMany * 4));
  folder.add("many_cells.csv", repeated(",", kMany * 4));
  folder.add("many_names.csv", repeated("position.x,", kMany));
  folder.add("many_keys.csv", repeated("# dt: 1\n", kMany));
  folder.add("nested_arrays.toml", "a = " + repeated("[", kMany));
  folder.add("nested_tables.toml", "[" + repeated("a.", kMany) + "a]\n");
  folder.add("many_tables.toml", repeated("[[box]]\n", kMany) + "no");
  folder.add("long_text.toml", "title = \"" + repeated("a", kMany * 4));
  folder.add("many_bodies.toml", "[[grid]]\nrows = 2147483647\ncols = 2147483647\n");
}

}  // namespace

Result<std::vector<std::string>> make_hostile_files(const std::string& folder) {
  Folder files(folder);
  for (const auto& [name, bytes] : make_hostile_logs()) files.add(name, bytes);
  add_texts(files);
  return files.paths();
}

}  // namespace tumble::trial
