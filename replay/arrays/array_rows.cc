#include "replay/arrays/array_rows.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "replay/arrays/known_arrays.h"
#include "replay/arrays/pair_cell.h"
#include "src/base/text.h"

namespace tumble::replay {

bool is_true(const std::string& cell) { return !cell.empty() && cell != "0"; }

std::string shape_text(const std::vector<std::size_t>& shape) {
  std::string text = "(";
  for (const std::size_t n : shape) text += (text.size() == 1 ? "" : ", ") + std::to_string(n);
  return text + ")";
}

const Array* find_array(const std::vector<Array>& arrays, std::string_view name) {
  const auto found = std::ranges::find(arrays, name, &Array::name);
  return found == arrays.end() ? nullptr : &*found;
}

bool is_unit(const Array& array) {
  return array.shape.empty() && !array.is_number() && array.cell({}).find_first_of("\r\n") == std::string::npos;
}

std::string unit_behind(const std::vector<Array>& arrays, const Array& array) {
  const Array* unit = find_array(arrays, "unit." + array.name);
  return unit == nullptr ? "" : " (" + unit->cell({}) + ')';
}

std::vector<std::string> bodiless_ends(const Array& present) {
  const auto has_body = [&present](std::size_t k) {
    for (std::size_t body = 0; body < present.shape[1]; ++body) {
      if (is_true(present.cell({k, body}))) return true;
    }
    return false;
  };
  std::size_t first = 0, end = present.shape[0];
  while (first < end && !has_body(first)) ++first;
  while (end > first && !has_body(end - 1)) --end;
  std::vector<std::string> parts;
  const auto add = [&parts](std::size_t count, const char* where) {
    if (count > 0) parts.push_back(count_text(count, "step") + " without a body at the " + where + ", left out");
  };
  add(first, "start");
  add(present.shape[0] - end, "end");
  return parts;
}

std::vector<std::string> odd_parts(const std::vector<Array>& arrays, const Array* present) {
  std::vector<std::string> parts;
  const auto look = [&](const ArrayNames& names) {
    const Array* read = nullptr;
    for (const std::string_view name : names) {
      const Array* array = name.empty() ? nullptr : find_array(arrays, name);
      if (array != nullptr && read != nullptr) {
        parts.push_back("arrays " + read->name + " and " + array->name + " have one meaning: " + read->name +
                        " is read, and " + array->name + " is kept as a channel; call it _" + array->name +
                        " to pass over it");
      }
      if (read == nullptr) read = array;
    }
  };
  for (const KnownArray& known : kMoving) look(known.names);
  for (const KnownArray& known : kSteady) look(known.names);
  for (const ArrayNames& names : {kStepNames, kTimeNames, kIdNames, kNameNames}) look(names);
  if (present != nullptr) {
    for (std::string& part : bodiless_ends(*present)) parts.push_back(std::move(part));
  }
  return parts;
}

std::string ChannelPart::cell(std::size_t step, std::size_t body) const {
  std::vector<std::size_t> at = {step};
  if (of_bodies) at.push_back(body);
  if (present != nullptr && !is_true(present->cell(at))) return {};
  if (many) at.push_back(part);
  std::string cell = values->cell(at);
  if (texts != nullptr) {
    std::size_t row = 0;
    std::from_chars(cell.data(), cell.data() + cell.size(), row);
    if (row >= texts->size()) return {};
    cell = texts->cell({row});
  }
  // Without an array that says so, an empty text is no value.
  return cell.empty() && present != nullptr ? kEmptyText : cell;
}

const char* ChannelPart::kind() const {
  if (texts != nullptr || !values->is_number()) return "text";
  if (values->kind == Array::Kind::kFloat) return values->item_bytes == 4 ? "float32" : "float64";
  return values->kind == Array::Kind::kUnsigned && values->item_bytes == 8 ? "uint64" : "int64";
}

std::string header_line(const Array& array) {
  const bool has_three = array.shape == std::vector<std::size_t>{3} && array.is_number() &&
                         std::ranges::find(kKeysOfThree, array.name) != kKeysOfThree.end();
  if (!has_three && !array.shape.empty()) return {};
  const std::string value =
      has_three ? array.cell({0}) + ' ' + array.cell({1}) + ' ' + array.cell({2}) : array.cell({});
  return "# " + array.name + ": " + value + '\n';
}

std::string kinds_line(const std::vector<TableColumn>& columns, const std::vector<std::string>& kinds) {
  const auto channels = std::ranges::count_if(columns, [](const TableColumn& column) {
    return column.name.starts_with("channel.") || column.name.starts_with("world.") || column.name.starts_with("pair.");
  });
  if (kinds.empty() || std::cmp_not_equal(channels, kinds.size())) return {};
  std::string line = "# kinds:";
  for (const std::string& kind : kinds) line += ' ' + kind;
  return line + '\n';
}

std::string print_rows(const std::string& header, const std::vector<TableColumn>& columns, std::size_t steps,
                       std::size_t bodies, const Array* present) {
  constexpr std::size_t kHeadMost = 4096;
  std::string text;
  bool escaped = false;
  const auto append = [&](std::size_t column, const std::string& cell) {
    if (column > 0) text += ',';
    if (cell.empty()) return;
    const std::string written = text_cell(cell == kEmptyText ? "" : cell);
    escaped = escaped || written != cell;
    text += written;
  };
  for (std::size_t i = 0; i < columns.size(); ++i) append(i, columns[i].name);
  text += '\n';
  const std::size_t names = text.size();
  for (std::size_t k = 0; k < steps; ++k) {
    // As long as the steps before, and some more: text that grows is copied.
    if (k == 2) text.reserve(text.size() + (text.size() - names) * (steps - 2) / 2 * 9 / 8 + kHeadMost);
    for (std::size_t body = 0; body < bodies; ++body) {
      if (present != nullptr && !is_true(present->cell({k, body}))) continue;
      for (std::size_t i = 0; i < columns.size(); ++i) append(i, columns[i].cell(k, body));
      text += '\n';
    }
  }
  text.insert(0, std::string(kRowsOfArrays) + '\n' + header + (escaped ? std::string(kEscapesLine) : ""));
  return text;
}

}  // namespace tumble::replay
