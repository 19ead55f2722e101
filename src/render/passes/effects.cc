#include "tumble/render/effects.h"

#include <array>
#include <utility>

namespace tumble::render {
namespace {

constexpr std::array<std::pair<const char*, bool Effects::*>, 6> kWords = {{{"specular", &Effects::specular},
                                                                            {"shadow", &Effects::shadow},
                                                                            {"bloom", &Effects::bloom},
                                                                            {"dof", &Effects::dof},
                                                                            {"motion", &Effects::motion},
                                                                            {"vertex", &Effects::vertex}}};

Effects none() { return {false, false, false, false, false, false}; }

bool Effects::*find_word(const std::string& word) {
  for (const auto& [name, member] : kWords) {
    if (word == name) return member;
  }
  return nullptr;
}

Error wanted(const std::string& list, const std::string& why) {
  return bad_input("--effects: found \"" + list + "\", " + why +
                   "; wanted all, none, or some of specular,shadow,bloom,dof,motion,vertex; with a - before each "
                   "word, all but these");
}

}  // namespace

Result<Effects> parse_effects(const std::string& list) {
  if (list == "all") return Effects{};
  if (list == "none") return none();
  Effects only = none(), all_but;
  bool adds = false, takes = false;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    std::string word = list.substr(begin, end - begin);
    begin = end + 1;
    const bool minus = word.starts_with('-');
    if (minus) word.erase(0, 1);
    bool Effects::*const member = find_word(word);
    if (member == nullptr) return wanted(list, "which has the unknown word \"" + word + "\"");
    const bool is_vertex = member == &Effects::vertex;
    adds = adds || (!minus && !is_vertex);
    takes = takes || (minus && !is_vertex);
    if (!minus) only.*member = true;
    if (minus) all_but.*member = false;
    if (is_vertex) only.vertex = all_but.vertex = !minus;
  }
  if (adds && takes) return wanted(list, "which both names and takes away");
  return takes || (!adds && only.vertex) ? all_but : only;
}

std::string to_string(const Effects& effects) {
  if (effects == Effects{}) return "all";
  std::string text;
  for (const auto& [name, member] : kWords) {
    if (effects.*member) text += (text.empty() ? "" : ",") + std::string(name);
  }
  return text.empty() ? "none" : text;
}

}  // namespace tumble::render
