#pragma once

#include <string>

#include "tumble/sim/result.h"

namespace tumble::render {

/// The effects of chapter IV of the thesis, each with its own switch. Without any, boxes have plain textures.
struct Effects {
  bool specular = true;  ///< highlights, by the mask in the alpha of the albedo
  bool shadow = true;
  bool bloom = true;
  bool dof = true;      ///< depth of field; the camera's `blur` scales it
  bool motion = true;   ///< motion blur
  bool vertex = false;  ///< light per vertex, without specular, as in fixed-function OpenGL
  friend bool operator==(const Effects&, const Effects&) = default;
};

/// Reads "all", "none", or words separated by commas: "shadow,bloom" switches on only these, "-bloom,-dof" all others.
/// `vertex` goes with either form. Errors (kBadInput): an unknown word, a mixture of both forms.
Result<Effects> parse_effects(const std::string& list);

/// A list that parse_effects() reads back to equal effects.
std::string to_string(const Effects& effects);

}  // namespace tumble::render
