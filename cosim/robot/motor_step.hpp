// The steps in which the plant integrates motors (cosim/plant/clock.hpp), as far as a robot file must fit them.
#pragma once

namespace armature::cosim {

inline constexpr double kMotorStepSeconds = 5e-6;
// Of the speed that the speed loop changes in a step: a loop that changes more is close to unstable.
inline constexpr double kMaxSpeedLoopPerStep = 0.5;

}  // namespace armature::cosim
