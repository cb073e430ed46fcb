// The activities of core 1. A new one is a member here, with its place in all(), and its source in sources.hpp.
#pragma once

#include <tuple>

#include "controller/activity/activity_context.hpp"
#include "controller/activity/conveyor/conveyor_activity.hpp"
#include "controller/activity/homing/homing_activity.hpp"
#include "controller/activity/jog/jog_activity.hpp"
#include "controller/activity/plans/plan_activity.hpp"
#include "controller/activity/stream/stream_activity.hpp"

namespace armature {

struct Activities {
  explicit Activities(const ActivityContext& context) noexcept
      : plans{context}, conveyor{context, plans}, jog{context}, homing{context}, stream{context} {}

  [[nodiscard]] auto all() noexcept { return std::tie(plans, conveyor, jog, homing, stream); }

  PlanActivity plans;
  ConveyorActivity conveyor;
  JogActivity jog;
  HomingActivity homing;
  StreamActivity stream;
};

}  // namespace armature
