// All branches of a pose, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "controller/kinematics/ik_result.hpp"
#include "cosim/cli/options/kinematics_io.hpp"
#include "cosim/poses/pose_frames.hpp"

namespace armature::cosim {

inline constexpr double kMetWithinDeg = 1e-9;  // rounding

[[nodiscard]] std::string solutions_table(const IkSolutions& solutions, const JointAngles& previous,
                                          const PoseFrames& frames, const ArmOfFile& robot);
[[nodiscard]] nlohmann::ordered_json solutions_json(const IkSolutions& solutions, const JointAngles& previous,
                                                    const ArmOfFile& robot);

}  // namespace armature::cosim
