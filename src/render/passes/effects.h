#pragma once

#include <string>

#include "src/base/result.h"

namespace tumble::render {

/// What chapter IV of the thesis adds to plain textured boxes, each on its own switch.
struct Effects {
  bool specular = true;  ///< highlights, by the mask in the albedo's alpha
  bool shadow = true;
  bool bloom = true;
  bool dof = true;      ///< depth of field; the camera's `blur` scales it
  bool motion = true;   ///< motion blur
  bool vertex = false;  ///< light the vertices and interpolate, without specular: what fixed-function OpenGL did
  friend bool operator==(const Effects&, const Effects&) = default;
};

/// "all", "none", or words with commas between: "shadow,bloom" is these alone, "-bloom,-dof" all but these, and
/// `vertex` joins either. Errors (kBadInput): an unknown word, a mixture of both forms.
Result<Effects> parse_effects(const std::string& list);

/// A list that parse_effects() reads back to the same.
std::string to_string(const Effects& effects);

}  // namespace tumble::render
