#include "replay/export/table/channel_cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "replay/arrays/pair_cell.h"
#include "src/base/text.h"

namespace tumble::replay {

bool fits_column(const std::string& unit) { return unit.find(" (") == std::string::npos && !unit.starts_with('('); }

std::string channel_column(const Channel& channel) {
  constexpr std::array<const char*, 3> kPrefixes = {"world.", "channel.", "pair."};  // by scope
  return kPrefixes.at(static_cast<std::size_t>(channel.type.scope)) + channel.name;
}

std::string unit_in_column(const Channel& channel) {
  const bool brackets = channel.name.ends_with(')') && channel.name.find(" (") != std::string::npos;
  const std::string unit = fits_column(channel.unit) ? channel.unit : "";
  return unit.empty() && !brackets ? std::string() : " (" + unit + ')';
}

std::string value_cell(const ChannelValue& value, ChannelKind kind) {
  if (const auto* wide = std::get_if<double>(&value)) return number_cell(*wide);
  if (const auto* narrow = std::get_if<float>(&value); narrow != nullptr && std::isinf(*narrow)) {
    return number_cell(*narrow);
  }
  return to_string(value, kind);
}

std::string pair_cell(const ChannelValues& values, ChannelKind kind, std::size_t row) {
  std::string cell;
  const sim::BodyId body = values.keys[row].a;
  for (; row < values.size() && values.keys[row].a == body; ++row) {
    const ChannelValue value = values.value(row, kind);
    const auto* text = std::get_if<std::string>(&value);
    cell += (cell.empty() ? "" : " ") + std::to_string(values.keys[row].b) + '=';
    if (text == nullptr) cell += value_cell(value, kind);
    if (text != nullptr) cell += kind == ChannelKind::kBytes ? hex_digits(*text) : escaped_cell(*text);
  }
  return cell;
}

std::size_t value_row(const ChannelValues& values, sim::BodyId id, std::size_t& from) {
  while (from < values.size() && values.keys[from].a < id) ++from;
  return from < values.size() && values.keys[from].a == id ? from : values.size();
}

}  // namespace tumble::replay
