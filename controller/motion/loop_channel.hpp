// What the motion loop tells core 1, beside its events.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/spsc_queue.hpp"
#include "controller/base/units.hpp"
#include "controller/motion/arm_position.hpp"

namespace armature {

struct Answer {
  enum class Kind : std::uint8_t {
    kRest,           // the arm stands at `position`: plans can begin there
    kFault,          // entered Fault; everything is dropped
    kFaultPersists,  // a ClearFault had no effect
    kUnusable,       // in Fault for good, core 0 sleeps: it will answer no order
    kRetargeted,     // the joint move that begins at once does so, and ends at `position`; earlier plans are dropped
    kNotRetargeted,  // it was refused, and earlier plans continue
  };
  Kind kind = Kind::kFault;
  PerAxis<Radians> position{};
  std::uint32_t number = 0;     // of the newest request that core 0 had read at that time (activity/request.hpp)
  std::uint8_t referenced = 0;  // mask of axes whose joint angles are known at that time
};

struct LoopChannel {
  static constexpr std::size_t kAnswers = 8;

  // Core 0 -> core 1, with an event. It cannot fill up, see Channel.
  SpscQueue<Answer, kAnswers> answers;
  ArmPosition position;  // core 0 -> core 1, in every tick
  // Core 1 -> core 0: core 1 waits for time to pass and must be woken by an event in every tick.
  std::atomic<bool> wake_each_tick{false};
  std::uint32_t number = 0;  // of core 0 only: as in an answer
};

}  // namespace armature
