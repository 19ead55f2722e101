#pragma once

#include "src/model/camera.h"
#include "src/scenes/table_reader.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/limits.h"

/// The ranges of the scene format, with the words of messages about them. Limits of the simulation come from
/// src/model/limits.h and camera.h; the other limits only catch typing errors.
namespace tumble::scenes {

inline constexpr NumberRule kSizeRule = {"three edge lengths", sim::kSizeMin, sim::kSizeMax, "m"};
inline constexpr NumberRule kMassRule = {"a mass", sim::kMassMin, sim::kMassMax, "kg"};
inline constexpr NumberRule kDensityRule = {"a density", 1e-6, 1e9, "kg/m³"};
inline constexpr NumberRule kPositionRule = {"three coordinates", -sim::kPositionMax, sim::kPositionMax, "m"};
inline constexpr NumberRule kVelocityRule = {"three components", -sim::kSpeedMax, sim::kSpeedMax, "m/s"};
inline constexpr NumberRule kSpinRule = {"three components", -sim::kSpeedMax, sim::kSpeedMax, "rad/s"};
inline constexpr NumberRule kImpulseRule = {"three components", -sim::kMassMax, sim::kMassMax, "N·s"};
inline constexpr NumberRule kQuaternionRule = {"four components w, x, y, z", -1e6, 1e6, ""};
inline constexpr NumberRule kAxisRule = {"three components", -1e6, 1e6, ""};
inline constexpr NumberRule kDegreesRule = {"an angle", -36000, 36000, "degrees"};

inline constexpr NumberRule kFrictionRule = {"a coefficient", 0, 100, ""};
inline constexpr NumberRule kRestitutionRule = {"a coefficient", 0, 1, ""};

inline constexpr NumberRule kDtRule = {"a time", sim::kDtMin, sim::kDtMax, "s"};
inline constexpr NumberRule kSecondsRule = {"a time", 0, 1e9, "s"};
inline constexpr IntegerRule kStepsRule = {"a whole number", 1, sim::kStepsMax};
inline constexpr IntegerRule kSubstepsRule = {"a whole number", 1, sim::kSubstepsMax};
inline constexpr NumberRule kGravityRule = {"three components", -sim::kGravityMax, sim::kGravityMax, "m/s²"};
inline constexpr IntegerRule kSplitRule = {"a whole number", 0, 1'000'000'000};
inline constexpr NumberRule kFreezeEnergyRule = {"an energy", 0, 1e6, "J/kg"};
inline constexpr NumberRule kFreezeTimeRule = {"a time", 0, 1e6, "s"};
inline constexpr NumberRule kSlipSpeedRule = {"a speed", 0, sim::kSpeedMax, "m/s"};
inline constexpr NumberRule kAirDragRule = {"a rate", 0, 1000, "1/s"};

inline constexpr IntegerRule kIdRule = {"a whole number", 1, sim::kBodyIdMax};
inline constexpr IntegerRule kCountRule = {"a whole number", 1, sim::kBodiesMax};
inline constexpr IntegerRule kCountsRule = {"three whole numbers", 1, sim::kBodiesMax};
inline constexpr NumberRule kDistanceRule = {"a distance", 0, sim::kPositionMax, "m"};
inline constexpr NumberRule kShiftRule = {"a distance", -sim::kPositionMax, sim::kPositionMax, "m"};
inline constexpr NumberRule kTiltRule = {"an angle", 0, 90, "degrees"};
inline constexpr NumberRule kTurnRule = {"an angle", 0, 180, "degrees"};
inline constexpr NumberRule kTaperRule = {"a ratio", 0.01, 100, ""};
inline constexpr IntegerRule kSeedRule = {"a whole number", 0, 9'223'372'036'854'775'807U};

inline constexpr NumberRule kViewRule = {"three coordinates", -sim::kViewMax, sim::kViewMax, "m"};
inline constexpr NumberRule kFovRule = {"an angle", sim::kFovMin, sim::kFovMax, "degrees"};
inline constexpr NumberRule kFocusRule = {"a distance", sim::kFocusMin, sim::kFocusMax, "m"};
inline constexpr NumberRule kBlurRule = {"a strength", 0, sim::kBlurMax, ""};

inline constexpr std::size_t kNameLengthMax = 100;
inline constexpr std::size_t kTitleLengthMax = 200;

}  // namespace tumble::scenes
