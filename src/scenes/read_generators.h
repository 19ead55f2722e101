#pragma once

#include "src/scenes/generators.h"
#include "src/scenes/table_reader.h"

namespace tumble::scenes {

/// The words of the scene format for the generators, in the order in which they are given ids. The index of a word is
/// the index of its shape in `Shape`.
inline constexpr const char* kGeneratorNames[] = {"grid", "tower", "pyramid", "wall", "pile"};

/// One generator's table; `shape` is the index of its kind. Reports a shape of too many bodies, and finishes the
/// reader.
Generator read_generator(TableReader& reader, std::size_t shape, std::uint32_t table,
                         const sim::Material& scene_material);

/// The bodies of a generator, each checked against the limits of size, mass and position that its table could not
/// show. Empty after an error.
std::vector<sim::BoxDef> generate_checked(const Generator& generator, const TableReader& reader);

}  // namespace tumble::scenes
