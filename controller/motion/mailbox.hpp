// What the two cores say to each other: plans and orders to the motion loop, news back. One queue a kind and direction.
#pragma once

#include <cstdint>

#include "controller/core/axes.hpp"
#include "controller/core/spsc_queue.hpp"
#include "controller/core/units.hpp"
#include "controller/trajectory/joint_move.hpp"

namespace armature {

// Overtakes all plans.
enum class MotionOrder : std::uint8_t {
  kStop,        // drop all plans, brake on the path; answered by kAtRest
  kClearFault,  // leave Fault; answered by kAtRest or, when the cause is still there, by kFault. Ignored outside Fault
};

struct MotionNews {
  enum class Kind : std::uint8_t {
    kAtRest,  // stands at `position` with nothing to do: ready for plans that begin there
    kFault,   // in Fault; all plans are dropped
  };
  Kind kind = Kind::kFault;
  PerAxis<Radians> position{};
};

struct MotionMailbox {
  static constexpr std::size_t kPlans = 8;
  // Orders wait for an answer before the next one, except that a fault may come in between; so these never fill up.
  static constexpr std::size_t kOrders = 4;
  static constexpr std::size_t kNews = 8;

  SpscQueue<JointPlan, kPlans> plans;      // core 1 -> core 0, each begins where the one before ends
  SpscQueue<MotionOrder, kOrders> orders;  // core 1 -> core 0
  SpscQueue<MotionNews, kNews> news;       // core 0 -> core 1, which is woken by an event; also when a plan is taken
};

}  // namespace armature
