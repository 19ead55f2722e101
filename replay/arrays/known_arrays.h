#pragma once

#include <array>
#include <string_view>

namespace tumble::replay {

/// The usual names of an array; empty ones stand for no name.
using ArrayNames = std::array<std::string_view, 4>;

/// An array that the format knows.
struct KnownArray {
  std::string_view field;  ///< of the table
  ArrayNames names;
  std::string_view letters;  ///< of the components; empty: a number a body
};

inline constexpr ArrayNames kPositions = {"position", "positions", "pos", "xpos"};
inline constexpr ArrayNames kStepNames = {"step", "steps"}, kTimeNames = {"time", "times", "t"};
inline constexpr ArrayNames kIdNames = {"id", "ids"}, kNameNames = {"name", "names", "body_names"};
inline constexpr std::array kMoving = {
    KnownArray{"position", kPositions, "xyz"},
    KnownArray{"orientation", {"orientation", "orientations", "quat", "xquat"}, "wxyz"},
    KnownArray{"velocity", {"velocity", "velocities", "vel", "linear_velocity"}, "xyz"},
    KnownArray{"spin", {"spin", "spins", "angular_velocity", "omega"}, "xyz"},
    KnownArray{"frozen", {"frozen", "asleep", "sleeping"}, ""}};
inline constexpr std::array kSteady = {KnownArray{"size", {"size", "sizes"}, "xyz"},
                                       KnownArray{"mass", {"mass", "masses"}, ""},
                                       KnownArray{"static", {"static", "is_static"}, ""},
                                       KnownArray{"friction", {"friction"}, ""},
                                       KnownArray{"restitution", {"restitution"}, ""},
                                       KnownArray{"shape", {"shape", "shapes"}, ""},
                                       KnownArray{"texture", {"texture"}, ""},
                                       KnownArray{"friction_dynamic", {"friction_dynamic"}, ""}};

/// Keys of the header that have three numbers.
inline constexpr std::array<std::string_view, 4> kKeysOfThree = {"gravity", "size", "camera.position", "camera.target"};

}  // namespace tumble::replay
