// The logic and the drives of a benchmark: core 0's register bus, at which an access is one load or store.
//
// What the logic and the drives do happens inside wait_for_interrupt(), outside of the time that is taken: the set
// committed before becomes active, the drives follow it exactly as the controller's model of them says, and `between`
// may give commands. What is timed, from the return of one wait to the call of the next, is the tick's software, this
// bus' accesses and one reading of the clock.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/motion/drive_model.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::bench {

class TickPlant final : public RegisterBus {
 public:
  // Runs for so many ticks, then switches the core off. `between` is called after each trigger with its number, from 0.
  TickPlant(const RobotModel& robot, std::size_t ticks, std::function<void(std::size_t)> between);

  [[nodiscard]] const std::vector<double>& tick_ns() const { return tick_ns_; }
  // Triggers without a new set. 0, or the figures mean nothing.
  [[nodiscard]] std::size_t underruns() const { return underruns_; }

  // RegisterBus
  std::uint32_t read32(RegAddr addr) noexcept override { return shown_[index(addr)]; }
  void write32(RegAddr addr, std::uint32_t value) noexcept override { written_[index(addr)] = value; }
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override;
  void send_event() noexcept override {}  // core 1 is served in every tick
  Cycles now() noexcept override;
  void charge(Work, std::int64_t) noexcept override {}

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kWordsPerBlock = 64;
  using Words = std::array<std::uint32_t, 4 * kWordsPerBlock>;

  // The low bits of the blocks' bases differ; all registers are in the first 256 bytes of their block.
  static constexpr std::size_t index(RegAddr addr) noexcept {
    return ((addr.value >> 16) & 3u) * kWordsPerBlock + ((addr.value & 0xFFu) >> 2);
  }
  void trigger() noexcept;

  std::size_t axis_count_;
  PerAxis<double> counts_per_pulse_;
  PerAxis<DriveModel> drives_;
  std::size_t ticks_;
  std::function<void(std::size_t)> between_;

  Words shown_{};    // what a read gives
  Words written_{};  // what was written last
  PerAxis<Pulses> active_{};
  std::size_t triggers_ = 0;
  std::size_t underruns_ = 0;
  bool awake_ = false;
  Clock::time_point woken_;
  std::vector<double> tick_ns_;
};

}  // namespace armature::bench
