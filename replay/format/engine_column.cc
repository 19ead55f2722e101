#include "replay/format/engine_column.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tumble::replay {
namespace {

enum class VectorKind : std::uint8_t { kLength, kDirection, kAxial, kExtents };

struct VectorField {
  std::string_view name;  ///< the last word before the axis
  VectorKind kind;
};

constexpr std::array<VectorField, 9> kVectorFields = {{{"position", VectorKind::kLength},
                                                       {"velocity", VectorKind::kLength},
                                                       {"gravity", VectorKind::kLength},
                                                       {"at", VectorKind::kLength},
                                                       {"impulse", VectorKind::kDirection},
                                                       {"normal", VectorKind::kDirection},
                                                       {"spin", VectorKind::kAxial},
                                                       {"orientation", VectorKind::kAxial},
                                                       {"size", VectorKind::kExtents}}};

}  // namespace

std::optional<EngineColumn> column_in(const EngineAxes& axes, std::string_view field) {
  if (field == "contact.depth") return EngineColumn{std::string(field), 1, true};
  const std::size_t dot = field.rfind('.');
  // A channel may be called "velocity.x"; its numbers are the engine's own.
  if (dot == std::string_view::npos || dot + 2 != field.size() || field.starts_with("channel.")) return std::nullopt;
  const std::string_view before = field.substr(0, dot);
  const std::size_t word = before.find_last_of(". ");
  const std::string_view vector = word == std::string_view::npos ? before : before.substr(word + 1);
  const auto* const known = std::ranges::find(kVectorFields, vector, &VectorField::name);
  if (known == kVectorFields.end()) return std::nullopt;
  const char letter = field.back();
  if (letter == 'w' && vector == "orientation") return EngineColumn{std::string(field), 1, false};
  if (letter < 'x' || letter > 'z') return std::nullopt;
  const bool is_axial = known->kind == VectorKind::kAxial, is_extent = known->kind == VectorKind::kExtents;
  const EngineAxis axis = is_axial ? axes.axial_along(letter - 'x') : axes.along(letter - 'x');
  return EngineColumn{std::string(before) + '.' + axis.letter, is_extent ? 1 : axis.sign,
                      is_extent || known->kind == VectorKind::kLength};
}

}  // namespace tumble::replay
