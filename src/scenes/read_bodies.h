#pragma once

#include <optional>

#include "src/scenes/table_reader.h"
#include "tumble/sim/scene.h"

namespace tumble::scenes {

/// [material] or a body's `material = { … }`: single keys over `base`. friction_dynamic follows friction where only
/// the latter is given.
sim::Material read_material(const toml::table& table, const std::string& label, const std::string& prefix,
                            const sim::Material& base, Problem& problem);

/// The keys that a box and every generator share: size, mass or density, material, frozen.
struct BodyTemplate {
  sim::Vec3 size = {1, 1, 1};
  double mass = 1;
  sim::Material material;
  bool frozen = false;
};
BodyTemplate read_body_template(TableReader& reader, const sim::Material& scene_material);

/// A [[box]], or the box of a throw; its id is 0 where the table gives none. Does not call finish().
sim::BoxDef read_box(TableReader& reader, const sim::Material& scene_material);

/// `id` or `first_id`, if the table has it.
std::optional<sim::BodyId> read_id(TableReader& reader, std::string_view key);

/// The turn by `degrees` about an axis, which need not have length 1 but must not be zero.
sim::Quat turned_about(const sim::Vec3& axis, double degrees);

}  // namespace tumble::scenes
