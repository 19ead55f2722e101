#pragma once

#include "src/render/gl/objects.h"
#include "src/render/picture/image.h"
#include "src/render/scene/view.h"

/// What a pass wrote, as an image to look at. Waits until it is drawn.
namespace tumble::render {

enum class Channels {
  kColour,  ///< red, green, blue
  kAlpha,   ///< as grey
};

/// Of a target of bytes, as they are.
Image read_bytes(const Gl& gl, const RenderTarget& target, Channels channels);
/// Of a target of floats: colours as square roots of linear light, as in the final image; alpha as it is.
Image read_floats(const Gl& gl, const RenderTarget& target, Channels channels);
/// Of the depth map: distance from the light along its gaze as grey, from black for the nearest to white for the
/// farthest surface; white where there is none.
Image read_depth(const Gl& gl, const RenderTarget& map, const View& light);

}  // namespace tumble::render
