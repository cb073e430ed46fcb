// Finds when in a plan the outputs of its moves are switched.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/joint_chain.hpp"
#include "controller/trajectory/plan/joint_move.hpp"

namespace armature {

// Each sets the outputs of a plan whose times are set. The chains must have at most TimedOutputs::kMax. If an output is
// before the start or behind the end of the plan, the outputs of the plan are not valid.

// Returns the first segment with such an output.
[[nodiscard]] std::optional<std::size_t> place_outputs(CartesianPlan& plan,
                                                       std::span<const SegmentRequest> chain) noexcept;
// Outputs in time only. Returns false if there is such an output.
[[nodiscard]] bool place_outputs(JointPlan& plan, const PathOutputs& outputs) noexcept;
// `outputs` of each move of the chain, in time only. Returns the first move with such an output.
[[nodiscard]] std::optional<std::size_t> place_outputs(JointChain& chain,
                                                       std::span<const PathOutputs> outputs) noexcept;

}  // namespace armature
