// The pulse-and-direction input of a servo drive: one pulse per rising edge of `step`, signed by `dir` at that edge.
//
// The input is as strict as the drive's data sheet: a pulse, pause, set-up or hold time below the required one is a
// violation, because a real drive may then count wrongly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "controller/base/units.hpp"
#include "cosim/logic/whole_tick.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

// Level of `dir` that counts pulses up.
inline constexpr bool kDirForward = true;

// Requirements in clock cycles; a time of the data sheet that is no whole number of cycles is rounded up.
struct StepTiming {
  Cycles min_high{};   // step high, rising to falling edge
  Cycles min_low{};    // step low, falling to rising edge
  Cycles dir_setup{};  // last change of dir to a rising step edge
  Cycles dir_hold{};   // last falling step edge to a change of dir; dir must not change while step is high

  static StepTiming from(const DriveSpec& spec);
};

enum class InputRule : std::uint8_t { kStepHigh, kStepLow, kDirSetup, kDirHold };

struct InputViolation {
  std::size_t axis = 0;  // 0..5
  Cycles cycle{};        // of the edge that came too early
  InputRule rule = InputRule::kStepHigh;
  Cycles measured{};
  Cycles required{};
};

// "axis 3, cycle 12345: direction set-up 24 cycles (480 ns), the drive needs 25 cycles (500 ns)"
[[nodiscard]] std::string describe(const InputViolation& violation);

class StepInput {
 public:
  StepInput(std::size_t axis, const StepTiming& timing) : axis_{axis}, timing_{timing} {}

  // Whether the pulses keep all times.
  [[nodiscard]] bool accepts(const AxisPulses& pulses) const;
  // The levels after pulses that were not seen one by one, and the edges of the latest changes.
  void resume(bool step, bool dir, Cycles changed, Cycles turned);

  // Levels after clock edge `now`; must be called when one of them has changed. Returns the pulse: +1, -1 or 0. Before
  // the first call both lines count as low for longer than every required time. With `checked` false (servo off: the
  // drive ignores its input) edges are followed but their timing is not checked.
  int update(Cycles now, bool step, bool dir, bool checked);

  // The first violation of the run.
  [[nodiscard]] const std::optional<InputViolation>& violation() const { return violation_; }

 private:
  void require(Cycles now, Cycles measured, InputRule rule, Cycles required);

  std::size_t axis_;
  StepTiming timing_;
  bool step_ = false;
  bool dir_ = false;
  // Long before the start of the run, and far from overflow.
  Cycles last_rise_{-(std::int64_t{1} << 60)};
  Cycles last_fall_{-(std::int64_t{1} << 60)};
  Cycles turned_{-(std::int64_t{1} << 60)};
  std::optional<InputViolation> violation_;
};

}  // namespace armature::cosim
