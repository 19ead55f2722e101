#pragma once

#include "src/render/gl/objects.h"
#include "src/render/scene/view.h"
#include "tumble/render/image.h"

/// Reads the result of a pass as an image for people. Waits until the pass is finished.
namespace tumble::render {

enum class Channels {
  kColour,  ///< red, green, blue
  kAlpha,   ///< as grey
};

/// Reads a target of bytes, unchanged.
Image read_bytes(const Gl& gl, const RenderTarget& target, Channels channels);
/// Reads a target of floats: colours as square roots of linear light, as in the final image; alpha unchanged.
Image read_floats(const Gl& gl, const RenderTarget& target, Channels channels);
/// Reads the depth map: distance from the light along its direction as grey, black for the nearest surface, white for
/// the farthest and where no surface is.
Image read_depth(const Gl& gl, const RenderTarget& map, const View& light);

}  // namespace tumble::render
