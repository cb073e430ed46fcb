// What benchmarks, which use path_rig.hpp too, have no use for.
#pragma once

#include <gtest/gtest.h>

#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

// The plan ends with the tool at `target`, to rounding.
inline void expect_reached(const PathRig& rig, const Transform& target) {
  const Transform reached = rig.tool_at(rig.planner.plan().target);
  EXPECT_LT((reached.position_mm - target.position_mm).norm(), 1e-9);
  EXPECT_LT((reached.rotation - target.rotation).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace armature::test
