// Finds where in a plan the outputs of its segments are switched.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"

namespace armature {

// Sets the outputs of a plan whose times are set, in the order of time. Returns the first segment with an output before
// the start or behind the end of the plan; then the outputs of the plan are not valid.
[[nodiscard]] std::optional<std::size_t> place_outputs(CartesianPlan& plan,
                                                       std::span<const SegmentRequest> chain) noexcept;

}  // namespace armature
