// What the motion loop tells core 1, beside its events, and how it watches core 1.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/spsc_queue.hpp"
#include "controller/base/units.hpp"
#include "controller/hal/register_bus.hpp"
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
  static constexpr std::uint32_t kNotStarted = 0;

  // Core 0 -> core 1, with an event. It cannot fill up, see Channel.
  SpscQueue<Answer, kAnswers> answers;
  ArmPosition position;  // core 0 -> core 1, in every tick
  // Core 1 -> core 0: core 1 waits for time to pass and must be woken by an event in every tick.
  std::atomic<bool> wake_each_tick{false};
  // Core 0 -> core 1, with an event, and back: the newest question of the watch, and the last one that core 1 has seen.
  std::atomic<std::uint32_t> question{kNotStarted + 1};
  std::atomic<std::uint32_t> answered{kNotStarted};
  // Core 1 -> core 0: a word of the code is not what it was at the start (app/code_check.hpp).
  std::atomic<bool> code_changed{false};
  std::uint32_t number = 0;  // of core 0 only: as in an answer
};

// Core 0 watches core 1.
//
// A core 1 that hangs is silent: the arm stands under power where its plans end, no command is executed, and the
// pendant gets no answer. So core 0 asks it twenty times a second, and core 1 answers in each round of its loop
// (app/core1_loop.hpp). Without an answer for a quarter of a second the motion loop enters Fault. In the shipped
// scenarios the longest round of core 1 takes 1.6 ms.
class Core1Watch {
 public:
  static constexpr Ticks kPeriod{1'000};    // from question to question
  static constexpr Ticks kPatience{5'000};  // from a question to its answer

  // `channel` must outlive the watch.
  explicit Core1Watch(LoopChannel& channel) noexcept : channel_{channel} {}

  // Call once in each tick. Asks when it is time. A core 1 that has not started is not watched.
  void observe(Ticks now, RegisterBus& bus) noexcept {
    const std::uint32_t answered = channel_.answered.load(std::memory_order_relaxed);
    const std::uint32_t question = channel_.question.load(std::memory_order_relaxed);
    const bool waits = answered != question;
    silent_ = waits && answered != LoopChannel::kNotStarted && now - asked_ >= kPatience;
    if (waits || now - asked_ < kPeriod) return;
    asked_ = now;
    channel_.question.store(question + 1, std::memory_order_relaxed);
    bus.send_event();
  }

  // Whether core 1 has found a change of the code. Both cores may compute anything then.
  [[nodiscard]] bool code_changed() const noexcept { return channel_.code_changed.load(std::memory_order_relaxed); }

  // Whether core 1 has not answered for kPatience.
  [[nodiscard]] bool silent() const noexcept { return silent_; }

 private:
  LoopChannel& channel_;
  Ticks asked_{};
  bool silent_ = false;
};

}  // namespace armature
