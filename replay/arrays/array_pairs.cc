#include "replay/arrays/array_pairs.h"

#include <charconv>
#include <map>

#include "replay/arrays/array_rows.h"
#include "replay/arrays/pair_cell.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// Indexes by the text of an array's numbers; by 0 or 1 upwards where there is no array.
std::map<std::string, std::size_t> index_of(const Array* numbers, std::size_t count, std::size_t first) {
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < count; ++i) {
    index.emplace(numbers == nullptr ? std::to_string(i + first) : numbers->cell({i}), i);
  }
  return index;
}

std::string value_cell(const PairArrays& pairs, std::size_t row) {
  std::string cell = pairs.values->cell({row});
  if (pairs.texts == nullptr) return pairs.values->is_number() ? cell : escaped_cell(cell);
  std::size_t text = 0;
  std::from_chars(cell.data(), cell.data() + cell.size(), text);
  return text < pairs.texts->size() ? escaped_cell(pairs.texts->cell({text})) : std::string();
}

}  // namespace

Result<PairCells> pair_cells(const PairArrays& pairs, const PairPlaces& places) {
  const std::string& name = pairs.values->name;
  const std::vector<std::size_t>& shape = pairs.values->shape;
  if (shape.size() != 1)
    return bad_input("array " + name + ": found the shape " + shape_text(shape) + ", wanted (rows)");
  const std::pair<const char*, const Array*> others[] = {{"step.", pairs.steps}, {"a.", pairs.a}, {"b.", pairs.b}};
  for (const auto& [prefix, array] : others) {
    if (array == nullptr || array->shape != shape || !array->is_number()) {
      const std::string found = array == nullptr ? "none" : "the shape " + shape_text(array->shape);
      const std::string wanted = "numbers of " + shape_text(shape) + ", as the values have";
      return bad_input("array " + (prefix + name) + ": " + found_wanted(found, wanted));
    }
  }
  if (places.ids == nullptr ? places.named : !places.ids->is_number()) {
    return bad_input("array " + name + ": found bodies with names alone, wanted an array id of numbers, by which " +
                     "values of pairs name their bodies");
  }
  const std::map<std::string, std::size_t> steps = index_of(places.steps, places.step_count, 0);
  const std::map<std::string, std::size_t> bodies = index_of(places.ids, places.body_count, 1);
  PairCells cells(places.step_count);
  for (std::size_t row = 0; row < shape[0]; ++row) {
    const std::string step = pairs.steps->cell({row}), a = pairs.a->cell({row}), b = pairs.b->cell({row});
    const auto k = steps.find(step);
    const auto body = bodies.find(a);
    const auto at = [&] { return name + ", row " + std::to_string(row) + ": "; };
    if (k == steps.end()) return bad_input(at() + "found step " + step + ", which the archive lacks");
    if (body == bodies.end()) return bad_input(at() + "found body " + a + ", which the archive lacks");
    if (places.present != nullptr && !is_true(places.present->cell({k->second, body->second}))) {
      return bad_input(at().append("found body ").append(a).append(" at step ").append(step) + ", where it is absent");
    }
    std::string& cell = cells[k->second][body->second];
    cell += (cell.empty() ? "" : " ") + b + '=' + value_cell(pairs, row);
  }
  return cells;
}

}  // namespace tumble::replay
