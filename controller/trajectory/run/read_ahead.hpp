// Brings what the first ticks of a plan read into the caches of core 0, a part in each tick before.
//
// Core 1 has just written the plan, so core 0 would wait for the memory of each part of it that it reads. In the tick
// in which a window replaces the active plan, these waits would take longer than all other work.
#pragma once

#include <cstdint>

#include "controller/trajectory/cartesian/cartesian_plan.hpp"

namespace armature {

class ReadAhead {
 public:
  // Once in each tick in which `next` waits for its time. It only asks for memory and waits for none.
  void advance(const CartesianPlan& next) noexcept;

 private:
  const CartesianPlan* plan_ = nullptr;
  std::uint8_t part_ = 0;  // the next one
};

}  // namespace armature
