#pragma once

namespace tumble::test {

/// A table for `import`: one cube that rests on the ground for a step.
inline constexpr const char* kSmallTable =
    "# dt: 0.01\n"
    "step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
    "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z\n"
    "0,1,0,0,0.5,1,0,0,0,0,0,0,0,0,0\n1,1,0,0,0.5,1,0,0,0,0,0,0,0,0,0\n";

}  // namespace tumble::test
