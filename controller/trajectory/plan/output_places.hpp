// Finds when in a plan the outputs of its moves are switched.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/joint/joint_chain.hpp"
#include "controller/trajectory/joint/joint_move.hpp"
#include "controller/trajectory/path/path_output.hpp"

namespace armature {

// The ticks of an output of this segment, in a plan whose times are set. Nothing: it is before the start or behind the
// end of the plan.
[[nodiscard]] std::optional<double> output_ticks(const CartesianPlan& plan, std::size_t segment,
                                                 const PathOutput& output) noexcept;

// Each sets the outputs of a joint plan whose times are set, in time only. The chain must have at most
// TimedOutputs::kMax. If an output is before the start or behind the end of the plan, the outputs of the plan are not
// valid.

// Returns false if there is such an output.
[[nodiscard]] bool place_outputs(JointPlan& plan, const PathOutputs& outputs) noexcept;
// `outputs` of each move of the chain. Returns the first move with such an output.
[[nodiscard]] std::optional<std::size_t> place_outputs(JointChain& chain,
                                                       std::span<const PathOutputs> outputs) noexcept;

}  // namespace armature
