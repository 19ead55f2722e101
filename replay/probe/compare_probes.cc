#include "replay/probe/compare_probes.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

namespace tumble::replay {
namespace {

constexpr std::size_t kNone = ~std::size_t{0};

/// Numbers of the names, common to both files.
using Names = std::map<std::string, std::uint32_t>;

std::vector<std::uint32_t> name_of_sites(const ProbeFile& file, Names& names) {
  std::vector<std::uint32_t> numbers;
  for (const ProbeSite& site : file.sites) {
    numbers.push_back(names.emplace(site.name, static_cast<std::uint32_t>(names.size())).first->second);
  }
  return numbers;
}

/// The probes of a file sorted by name and key; of one name and key in their order.
class Sorted {
 public:
  Sorted(const ProbeFile& file, Names& names) : file_(file), names_(name_of_sites(file, names)) {
    order_.resize(file.probes.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, {}, [this](std::size_t i) { return key(i); });
  }

  using Key = std::tuple<std::uint32_t, bool, std::uint64_t, std::uint64_t>;
  [[nodiscard]] Key key(std::size_t i) const {
    const Probe& probe = file_.probes[i];
    return {names_[probe.site], probe.of_pair, probe.a, probe.b};
  }
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] std::size_t index(std::size_t place) const { return order_[place]; }
  [[nodiscard]] Key key_at(std::size_t place) const { return key(order_[place]); }

 private:
  const ProbeFile& file_;
  std::vector<std::uint32_t> names_;  // by site
  std::vector<std::size_t> order_;
};

bool same_value(const Probe& a, const Probe& b) { return a.kind == b.kind && a.bits == b.bits; }

}  // namespace

ProbeComparison compare_probes(const ProbeFile& a, const ProbeFile& b) {
  Names names;
  const Sorted in_a(a, names), in_b(b, names);
  std::vector<std::size_t> partner(a.probes.size(), kNone);
  std::vector<std::uint64_t> occurrence(a.probes.size(), 0);
  ProbeComparison result;
  std::uint64_t repeats = 0;
  for (std::size_t i = 0, j = 0; i < in_a.size() || j < in_b.size();) {
    const bool a_left = i < in_a.size(), b_left = j < in_b.size();
    if (a_left && (!b_left || in_a.key_at(i) < in_b.key_at(j))) {
      result.only_a.push_back(in_a.index(i++));
    } else if (b_left && (!a_left || in_b.key_at(j) < in_a.key_at(i))) {
      result.only_b.push_back(in_b.index(j++));
    } else {
      repeats = i > 0 && j > 0 && in_a.key_at(i - 1) == in_a.key_at(i) ? repeats + 1 : 0;
      partner[in_a.index(i)] = in_b.index(j);
      occurrence[in_a.index(i++)] = repeats;
      ++j;
    }
  }
  std::ranges::sort(result.only_a);
  std::ranges::sort(result.only_b);
  std::size_t next_b = 0, first_of_b = kNone;  // in B's order
  for (std::size_t i = 0; i < a.probes.size(); ++i) {
    const std::size_t j = partner[i];
    if (j == kNone) continue;
    ++result.matched;
    const ProbePair pair{i, j, occurrence[i]};
    if (j < next_b && !result.reordered) result.reordered = pair;
    next_b = std::max(next_b, j + 1);
    if (same_value(a.probes[i], b.probes[j])) {
      if (!result.first) result.same_before.push_back(pair);
      if (result.same_before.size() > kSameBeforeMax) result.same_before.erase(result.same_before.begin());
      continue;
    }
    ++result.different;
    if (!result.first) result.first = pair;
    if (j >= first_of_b) continue;
    first_of_b = j;
    result.first_by_b = pair;
  }
  if (result.first_by_b && result.first_by_b->a == result.first->a) result.first_by_b.reset();
  return result;
}

}  // namespace tumble::replay
