#include "tests/bench/tick_plant.hpp"

#include <cmath>
#include <utility>

#include "controller/core/timebase.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature::bench {
namespace {

namespace pt = regs::pulse_train;
namespace en = regs::encoder;
using regs::insert;
constexpr RegAddr kPulseTrain{regs::soc::kPulseTrainBase};
constexpr RegAddr kEncoder{regs::soc::kEncoderBase};

RegAddr element(RegAddr base, std::uint32_t offset, std::size_t axis) {
  return base + (offset + 4 * static_cast<std::uint32_t>(axis));
}

}  // namespace

TickPlant::TickPlant(const RobotModel& robot, std::size_t ticks, std::function<void(std::size_t)> between)
    : axis_count_{robot.axis_count},
      counts_per_pulse_{make_per_axis([&](std::size_t axis) {
        return static_cast<double>(robot.axes[axis].counts_per_rev) / robot.axes[axis].pulses_per_rev;
      })},
      drives_{make_per_axis([&](std::size_t axis) {
        return DriveModel{robot.axes[axis].drive_natural_rad_s, robot.axes[axis].drive_damping};
      })},
      ticks_{ticks},
      between_{std::move(between)} {
  tick_ns_.reserve(ticks);
  shown_[index(kPulseTrain + pt::kIdOffset)] = pt::kIdWord;
  shown_[index(kEncoder + en::kIdOffset)] = en::kIdWord;
  shown_[index(kEncoder + en::kKnownOffset)] = en::kKnownAxesMask;
}

Interrupts TickPlant::wait_for_interrupt(Interrupts) noexcept {
  const Clock::time_point slept = Clock::now();
  if (awake_) tick_ns_.push_back(std::chrono::duration<double, std::nano>(slept - woken_).count());
  if (triggers_ == ticks_) return Interrupts::kNone;
  awake_ = true;
  trigger();
  between_(triggers_++);
  woken_ = Clock::now();
  return Interrupts::kTimer;
}

void TickPlant::trigger() noexcept {
  for (std::size_t axis = 0; axis < axis_count_; ++axis) {
    DriveModel& drive = drives_[axis];
    drive.step(active_[axis]);
    const double position = static_cast<double>(drive.sent().value()) - drive.lag();
    const auto counts = static_cast<std::int32_t>(std::floor(position * counts_per_pulse_[axis] + 0.5));
    shown_[index(element(kEncoder, en::kPositionOffset, axis))] = static_cast<std::uint32_t>(counts);
    const std::uint32_t count = written_[index(element(kPulseTrain, pt::kCountOffset, axis))];
    active_[axis] = Pulses{static_cast<std::int16_t>(count)};
  }
  const std::uint32_t sequence = insert(0, pt::kStatusSequence, written_[index(kPulseTrain + pt::kCommitOffset)]);
  std::uint32_t& status = shown_[index(kPulseTrain + pt::kStatusOffset)];
  if (status == sequence) ++underruns_;
  status = sequence;
}

Cycles TickPlant::now() noexcept {
  return Cycles{static_cast<std::int64_t>(triggers_) * kTickCycles.value()};
}

}  // namespace armature::bench
