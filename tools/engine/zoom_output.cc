#include <algorithm>
#include <bit>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "replay/probe/tumble_probe.h"
#include "tools/engine/zoom.h"
#include "tumble/replay/field_value.h"

namespace tumble::tools {
namespace {

using replay::Probe;
using replay::ProbeFile;
using replay::ProbePair;

constexpr std::size_t kLackingShown = 3;

std::string place_text(const ProbeFile& file, const Probe& probe) {
  const replay::ProbeSite& site = file.sites[probe.site];
  return printable(site.file) + ":" + std::to_string(site.line);
}

std::string name_text(const ProbeFile& file, const Probe& probe) {
  return printable(file.sites[probe.site].name) + ", key " + replay::key_text(probe);
}

std::string time_text(std::uint64_t occurrence) {
  return occurrence == 0 ? "" : ", time " + std::to_string(occurrence + 1) + " in the step";
}

/// The distance of two doubles in units in the last place; empty for other values.
std::string distance_text(const Probe& a, const Probe& b) {
  if (a.kind != TUMBLE_PROBE_F64 || b.kind != TUMBLE_PROBE_F64) return "";
  const auto ulps = replay::ulps_between(std::bit_cast<double>(a.bits), std::bit_cast<double>(b.bits));
  return ulps ? count_text(*ulps, "ulp") + " apart" : "";
}

void print_pair(const Zoom& zoom, const ProbePair& pair, const Sides& sides) {
  const Probe &a = zoom.a.probes[pair.a], &b = zoom.b.probes[pair.b];
  std::cout << "  " << name_text(zoom.a, a) << time_text(pair.occurrence) << '\n';
  Listing listing;
  listing.add("    " + sides.expected, replay::value_text(a) + "  at " + place_text(zoom.a, a));
  listing.add("    " + sides.actual, replay::value_text(b) + "  at " + place_text(zoom.b, b));
  if (const std::string distance = distance_text(a, b); !distance.empty()) listing.add("", distance);
  listing.print();
}

void print_lacking(const ProbeFile& file, const std::vector<std::size_t>& only, std::size_t before,
                   const std::string& in, const std::string& not_in) {
  if (only.empty()) return;
  const auto earlier = std::ranges::count_if(only, [&](std::size_t i) { return i < before; });
  std::cout << "  only in " << in << ": " << count_text(only.size(), "probe") << " whose key " << not_in << " lacks";
  if (earlier > 0 && before != ~std::size_t{0}) {
    std::cout << ", " << earlier << " of them before the first difference";
  }
  std::cout << '\n';
  for (std::size_t k = 0; k < std::min(kLackingShown, only.size()); ++k) {
    const Probe& probe = file.probes[only[k]];
    std::cout << "    " << name_text(file, probe) << " = " << replay::value_text(probe) << "  at "
              << place_text(file, probe) << '\n';
  }
}

void print_warnings(const Zoom& zoom, const Sides& sides) {
  const auto stray = [](const std::string& name, const std::string& text) {
    if (text.empty()) return;
    std::cout << "  note: run again, the engine of " << name << " does not repeat that log: " << printable(text)
              << "; its probes are of the new run\n";
  };
  stray(sides.expected, zoom.stray_a);
  stray(sides.actual, zoom.stray_b);
  const auto cut = [](const std::string& name, const std::string& text) {
    if (!text.empty()) std::cout << "  note: the probes of " << name << " are not complete: " << text << '\n';
  };
  cut(sides.expected, zoom.a.cut);
  cut(sides.actual, zoom.b.cut);
}

Json probe_json(const ProbeFile& file, const Probe& probe) {
  const replay::ProbeSite& site = file.sites[probe.site];
  return {{"name", site.name},
          {"key", probe.of_pair ? Json{probe.a, probe.b} : Json{probe.a}},
          {"value", probe.kind == TUMBLE_PROBE_F64 ? number_json(std::bit_cast<double>(probe.bits))
                                                   : Json(replay::value_text(probe))},
          {"bits", hex_text(probe.bits)},
          {"file", site.file},
          {"line", site.line}};
}

Json pair_json(const Zoom& zoom, const ProbePair& pair) {
  return {{"occurrence", pair.occurrence},
          {"expected", probe_json(zoom.a, zoom.a.probes[pair.a])},
          {"actual", probe_json(zoom.b, zoom.b.probes[pair.b])}};
}

Json lacking_json(const ProbeFile& file, const std::vector<std::size_t>& only) {
  Json json = {{"count", only.size()}, {"first", Json::array()}};
  for (std::size_t k = 0; k < std::min(kLackingShown, only.size()); ++k) {
    json["first"].push_back(probe_json(file, file.probes[only[k]]));
  }
  return json;
}

}  // namespace

void print_zoom(const Zoom& zoom, const Sides& sides) {
  const replay::ProbeComparison& found = zoom.compared;
  const char* which = zoom.after_inputs ? ", the first whose state or phases have another hash: " : ": ";
  std::cout << "\nzoom into step " << zoom.step << which << zoom.a.probes.size() << " probes of " << sides.expected
            << ", " << zoom.b.probes.size() << " of " << sides.actual << "; " << found.matched
            << " matched by name and key, " << found.different << " of them different\n";
  print_warnings(zoom, sides);
  if (found.first) {
    std::cout << "first probe that differs\n";
    print_pair(zoom, *found.first, sides);
  } else {
    std::cout << "no probe that both passed differs: the difference arises where there is no probe\n";
  }
  if (found.first_by_b) {
    std::cout << "in the order of " << sides.actual << " another one is first\n";
    print_pair(zoom, *found.first_by_b, sides);
  }
  if (!found.same_before.empty())
    std::cout << (found.first ? "the same just before\n" : "the last that are the same\n");
  for (const ProbePair& pair : found.same_before) {
    const Probe& probe = zoom.a.probes[pair.a];
    std::cout << "  " << name_text(zoom.a, probe) << time_text(pair.occurrence) << " = " << replay::value_text(probe)
              << "  at " << place_text(zoom.a, probe) << '\n';
  }
  constexpr std::size_t kNowhere = ~std::size_t{0};
  print_lacking(zoom.a, found.only_a, found.first ? found.first->a : kNowhere, sides.expected, sides.actual);
  print_lacking(zoom.b, found.only_b, found.first ? found.first->b : kNowhere, sides.actual, sides.expected);
  if (found.reordered) {
    std::cout << "  the order differs: " << name_text(zoom.a, zoom.a.probes[found.reordered->a])
              << " stands elsewhere in " << sides.actual << "; probes were matched by key all the same\n";
  }
}

Json zoom_json(const Zoom& zoom) {
  const replay::ProbeComparison& found = zoom.compared;
  Json json = {{"step", zoom.step},
               {"probes", {zoom.a.probes.size(), zoom.b.probes.size()}},
               {"matched", found.matched},
               {"different", found.different},
               {"first", found.first ? pair_json(zoom, *found.first) : Json(nullptr)},
               {"first_in_order_of_b", found.first_by_b ? pair_json(zoom, *found.first_by_b) : Json(nullptr)},
               {"same_before", Json::array()}};
  for (const ProbePair& pair : found.same_before) {
    json["same_before"].push_back(probe_json(zoom.a, zoom.a.probes[pair.a]));
  }
  json["only_a"] = lacking_json(zoom.a, found.only_a);
  json["only_b"] = lacking_json(zoom.b, found.only_b);
  json["reordered"] = found.reordered ? probe_json(zoom.a, zoom.a.probes[found.reordered->a]) : Json(nullptr);
  json["strays"] = {zoom.stray_a, zoom.stray_b};
  json["incomplete"] = {zoom.a.cut, zoom.b.cut};
  json["commands"] = {zoom.command_a, zoom.command_b};
  return json;
}

}  // namespace tumble::tools
