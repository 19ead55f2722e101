#pragma once

#include "replay/export/plan/export_plan.h"

/// Colours and textures of bodies, those of `tumble render`.
namespace tumble::replay {

/// Linear light, 0 … 1.
struct Colour4 {
  double r = 1, g = 1, b = 1;
};

/// The variation of a body's material that its id selects: a factor of the texture's colours.
Colour4 tint_of(const ExportBody& body);

/// The mean colour of a body's texture with that factor, sRGB-encoded, for formats without textures.
Colour4 colour_of(const ExportBody& body);
Colour4 ground_colour();

}  // namespace tumble::replay
