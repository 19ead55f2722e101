#include <algorithm>
#include <bit>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tools/bench/bench.h"
#include "tools/bench/table1.h"

namespace tumble::tools {
namespace {

/// Adds up one mean.
class RatioSum {
 public:
  void add(const std::optional<double>& other, const std::optional<double>& ours) {
    if (!other || !ours) return;
    const double ratio = *other / *ours;
    log_sum_ += std::log(ratio);
    least_ = out_.cells == 0 ? ratio : std::min(least_, ratio);
    ++out_.cells;
  }
  [[nodiscard]] MeanRatio mean() const {
    if (out_.cells == 0) return out_;
    return {out_.cells, std::exp(log_sum_ / static_cast<double>(out_.cells)), least_};
  }

 private:
  MeanRatio out_;
  double log_sum_ = 0, least_ = 0;
};

std::string reference(const TableTime& time) {
  if (!time.seconds) return "N/A";
  return short_number(*time.seconds) + (time.failed ? " F" : "");
}

std::string ratio_text(const std::optional<double>& other, const std::optional<double>& ours) {
  return other && ours ? short_number(*other / *ours) : "";
}

std::vector<std::string> header(const std::vector<Table1Cell>& cells) {
  std::vector<std::string> names = {">cubes",  ">substeps", ">most",  ">mean", ">here",
                                    ">thesis", ">ratio",    ">Havok", ">ratio"};
  for (const PeerCell& peer : cells.front().peers) {
    names.push_back('>' + peer.engine);
    names.emplace_back(">ratio");
  }
  names.insert(names.end(), {">lateral", ">column spread"});
  return names;
}

std::vector<std::string> line(const Table1Cell& cell, sim::Method method) {
  const std::uint32_t most = most_substeps(cell.label(), method);
  std::vector<std::string> words = {
      std::to_string(cell.cubes()),
      std::to_string(cell.label()),
      std::to_string(most),
      cell.seconds ? fixed(cell.substeps_mean, 1) : "",
      cell.seconds ? short_number(*cell.seconds) + (cell.lost > 0 ? " F" : "") : "not run",
      short_number(cell.thesis()),
      ratio_text(cell.thesis(), cell.seconds),
      reference(cell.havok()),
      ratio_text(cell.havok().seconds, cell.seconds)};
  for (const PeerCell& peer : cell.peers) {
    words.push_back(peer.seconds ? short_number(*peer.seconds) : peer.failure.empty() ? "not run" : "failed");
    words.push_back(ratio_text(peer.seconds, cell.seconds));
  }
  words.push_back(cell.seconds ? rounded(cell.lateral, "m") : "");
  words.push_back(cell.seconds && cell.spread ? rounded(*cell.spread, "m") : "");
  return words;
}

std::string sentence(const MeanRatio& mean) {
  if (mean.cells == 0) return "no cell";
  return short_number(mean.mean) + " times in the geometric mean, " + short_number(mean.least) + " at least, of " +
         count_text(mean.cells, "cell");
}

Json mean_json(const MeanRatio& mean) {
  if (mean.cells == 0) return {{"cells", 0}, {"mean", nullptr}, {"least", nullptr}};
  return {{"cells", mean.cells}, {"mean", mean.mean}, {"least", mean.least}};
}

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json cell_json(const Table1Cell& cell, sim::Method method) {
  const bool ran = cell.seconds.has_value();
  Json out = {{"cubes", cell.cubes()},
              {"substeps", cell.label()},
              {"dt", cell.dt()},
              {"substeps_most", most_substeps(cell.label(), method)},
              {"substeps_mean", ran ? Json(cell.substeps_mean) : Json(nullptr)},
              {"substeps_largest", ran ? Json(cell.substeps_largest) : Json(nullptr)},
              {"cpu_s", optional_json(cell.seconds)},
              {"thesis_s", cell.thesis()},
              {"ratio", ran ? Json(cell.thesis() / *cell.seconds) : Json(nullptr)},
              {"havok_s", optional_json(cell.havok().seconds)},
              {"havok_failed", cell.havok().failed},
              {"lost", ran ? Json(cell.lost) : Json(nullptr)},
              {"lateral_max", ran ? Json(cell.lateral) : Json(nullptr)},
              {"column_spread", optional_json(cell.spread)}};
  out["engines"] = Json::array();
  for (const PeerCell& peer : cell.peers) {
    out["engines"].push_back({{"engine", peer.engine},
                              {"substeps", peer.substeps},
                              {"cpu_s", optional_json(peer.seconds)},
                              {"failure", peer.failure}});
  }
  return out;
}

}  // namespace

std::uint32_t most_substeps(int label, sim::Method method) {
  const auto n = static_cast<std::uint32_t>(label);
  return method == sim::Method::kThesis ? std::bit_floor(n) : n;
}

Table1Means means_of(const std::vector<Table1Cell>& cells, sim::Method method) {
  RatioSum thesis, same, havok;
  std::vector<RatioSum> engines(cells.front().peers.size());
  for (const Table1Cell& cell : cells) {
    thesis.add(cell.thesis(), cell.seconds);
    const bool as_labelled = most_substeps(cell.label(), method) == static_cast<std::uint32_t>(cell.label());
    if (as_labelled) same.add(cell.thesis(), cell.seconds);
    if (!cell.havok().failed) havok.add(cell.havok().seconds, cell.seconds);
    for (std::size_t k = 0; k < engines.size(); ++k) engines[k].add(cell.peers[k].seconds, cell.seconds);
  }
  Table1Means out = {thesis.mean(), same.mean(), havok.mean(), {}};
  for (std::size_t k = 0; k < engines.size(); ++k) {
    out.peers.emplace_back(cells.front().peers[k].engine, engines[k].mean());
  }
  return out;
}

void print_table1(const std::vector<Table1Cell>& cells, sim::Method method) {
  for (std::size_t half = 0; half < thesis_table1().size(); ++half) {
    std::cout << "\nconstant time " << thesis_table1()[half].name << " s; seconds of computation for 5 s\n";
    Table table(header(cells));
    for (const Table1Cell& cell : cells) {
      if (cell.half == half) table.add(line(cell, method));
    }
    table.print();
  }
  const Table1Means means = means_of(cells, method);
  std::cout << '\n'
            << means.thesis.cells << " of " << count_text(cells.size(), "cell") << " run\n"
            << "thesis / here: " << sentence(means.thesis) << '\n'
            << "thesis / here, as many substeps allowed as labelled: " << sentence(means.same_most) << '\n'
            << "Havok / here, without F: " << sentence(means.havok) << '\n';
  for (const auto& [engine, mean] : means.peers) {
    std::cout << engine << " / here, as many substeps as ours took: " << sentence(mean) << '\n';
  }
}

Json table1_json(const std::vector<Table1Cell>& cells, sim::Method method) {
  const Table1Means means = means_of(cells, method);
  Json out = {{"cells_run", means.thesis.cells},
              {"thesis_ratio", mean_json(means.thesis)},
              {"thesis_ratio_as_labelled", mean_json(means.same_most)},
              {"havok_ratio", mean_json(means.havok)}};
  out["engine_ratios"] = Json::array();
  for (const auto& [engine, mean] : means.peers) {
    Json row = mean_json(mean);
    row["engine"] = engine;
    out["engine_ratios"].push_back(std::move(row));
  }
  out["cells"] = Json::array();
  for (const Table1Cell& cell : cells) out["cells"].push_back(cell_json(cell, method));
  return out;
}

}  // namespace tumble::tools
