// The six axes at the pins of the logic: Drive -> Mechanics -> Encoder. Six drives turn pulses into demands, the
// mechanics moves all six shafts by them, six encoders show the shafts as edges.
//
// Time: outputs that the logic shows after clock edge c are processed with now = c; the inputs that follow from them,
// or from an event at c, are sampled by edge c + 1. At one cycle on_outputs() comes before advance().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/logic/axis_bits.hpp"
#include "cosim/logic/pins.hpp"
#include "cosim/logic/whole_tick.hpp"
#include "cosim/plant/axis_switches.hpp"
#include "cosim/plant/clock.hpp"
#include "cosim/plant/drop_out.hpp"
#include "cosim/plant/incremental_encoder.hpp"
#include "cosim/plant/mechanics.hpp"
#include "cosim/plant/plant_ticks.hpp"
#include "cosim/plant/servo_drive.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

class Plant {
 public:
  // The joints stand at `start_deg`, to the nearest encoder count, servos off. Throws std::invalid_argument when a
  // motor or encoder cannot be built. `drop_out`: see DropOut; none: there is no relay.
  explicit Plant(const RobotSpec& robot, std::optional<Cycles> drop_out = std::nullopt,
                 const PerAxis<double>& start_deg = {});
  Plant(const RobotSpec& robot, std::unique_ptr<Mechanics> mechanics, std::optional<Cycles> drop_out = std::nullopt,
        const PerAxis<double>& start_deg = {});

  // Must be called after each clock edge on which `step`, `dir`, `servo_on` or `heartbeat` has changed. Further calls
  // have no effect.
  void on_outputs(Cycles now, const SocOutputs& out);

  // The next cycle at which advance() must be called; kNever while every axis rests.
  [[nodiscard]] Cycles next_event() const { return ticks_ ? kNever : next_event_; }

  // Processes the events of cycle `now`. Earlier calls do nothing; a missed event throws std::logic_error.
  void advance(Cycles now);

  // The pins of encoders, switches and drives are the plant's; estop_n is high.
  [[nodiscard]] const SocInputs& inputs() const { return inputs_; }

  // The first violation of a drive's input timing; it ends the run.
  [[nodiscard]] const std::optional<InputViolation>& violation() const { return violation_; }

  // The servo enables as the drives see them, behind the relay; bit 0 is axis 1.
  [[nodiscard]] std::uint8_t servo_enables() const { return seen_.servo_on; }

  // Whether the relay has removed the servo power; false without a relay.
  [[nodiscard]] bool drop_out_open() const { return drop_out_ && drop_out_->is_open(); }

  // Fault script: the drive of `axis` does not see the next `count` pulses.
  void drop_pulses(std::size_t axis, std::int64_t count) { drives_[axis].drop_pulses(count); }
  [[nodiscard]] std::int64_t pulses_to_drop(std::size_t axis) const { return drives_[axis].pulses_to_drop(); }

  // Fault script: the drive counts the next `count` pulses twice.
  void double_pulses(std::size_t axis, std::int64_t count) { drives_[axis].double_pulses(count); }
  // Fault script: an internal fault of the drive, until as many calls of repair_drive().
  void trip_drive(std::size_t axis, Cycles now);
  void repair_drive(std::size_t axis);
  // Fault script: the motor shaft cannot turn, until as many calls of unblock().
  void block(std::size_t axis);
  void unblock(std::size_t axis);
  // Fault script: the holding brake of the axis has this share of its torque, of a plant that has brakes.
  void weaken_brake(std::size_t axis, double share, Cycles now);
  // Fault script: this torque acts on the joint [N m], of a plant whose joints are behind gears.
  void push(std::size_t axis, double torque_nm, Cycles now);
  // Whether the index would be high with the encoder so many counts further.
  [[nodiscard]] bool shows_index(std::size_t axis, Counts further) const {
    return encoders_[axis].z(encoders_[axis].count() + further);
  }

  // ---- whole ticks: the pulses of a tick at once, without the edges of pulses and encoders (plant_ticks.cpp). From
  // begin_tick() that returns true to resume_edges() nothing is due, on_outputs() sees no pulses, and inputs() stand
  // still.

  // Moves the motors through the steps of the tick, from its start to the edge before its end. Call it after
  // on_outputs() and before advance() of the cycle tick.begins. Returns false, and changes nothing, if more than pulses
  // and encoder lines could change in the tick, or if a level of a line would not last longer than `spacing`.
  [[nodiscard]] bool begin_tick(const TickPulses& tick, Cycles spacing);
  // Takes the tick back, to its start.
  void revert_tick();
  // Computes the edges again, from the end of the latest tick that was not taken back: after advance() of the cycle
  // `now`. `changed`, `turned`: the latest edges of step and dir, which now have the levels of `out`.
  void resume_edges(Cycles now, const SocOutputs& out, const PerAxis<Cycles>& changed, const PerAxis<Cycles>& turned);
  [[nodiscard]] bool leaves_out_edges() const { return ticks_.has_value(); }
  // The count of the encoder after the edges up to the cycle `at`, in the latest steps.
  [[nodiscard]] Counts count_after(std::size_t axis, Cycles at) const { return encoders_[axis].count_after(at); }
  // The count at which the index came in this tick; none: it did not come.
  [[nodiscard]] const PerAxis<std::optional<Counts>>& index_in_tick() const { return ticks_->index; }
  // The lines after `from` and before `now`, which is not in a tick that has begun.
  [[nodiscard]] LineHistory line_history(Cycles from, Cycles now) const;

  // ---- true state, for recorder and checks; axis 0..5. Pulses on the pins = drive + dropped + ignored, net of
  // direction.
  [[nodiscard]] Pulses drive_pulses(std::size_t axis) const { return drives_[axis].counted_pulses(); }
  [[nodiscard]] Pulses dropped_pulses(std::size_t axis) const { return drives_[axis].dropped_pulses(); }
  [[nodiscard]] Pulses ignored_pulses(std::size_t axis) const { return drives_[axis].ignored_pulses(); }
  [[nodiscard]] Counts motor_counts(std::size_t axis) const {
    return ticks_ ? ticks_->counts[axis] : encoders_[axis].count();
  }
  // The smallest and the largest count that the encoder showed from cycle `from` up to now.
  [[nodiscard]] CountRange motor_counts_since(std::size_t axis, Cycles from) const {
    return ticks_ ? counts_in_tick(axis, from) : encoders_[axis].counts_since(from);
  }
  // Where the motor was at the start and the end of the step before `now`, or at most one step before that. A motor
  // that rests makes no steps.
  struct MotorStep {
    Subcounts start, target;
  };
  [[nodiscard]] MotorStep motor_step_before(std::size_t axis, Cycles now) const {
    const IncrementalEncoder::Motions& motions = encoders_[axis].motions();
    const IncrementalEncoder::Motion& latest = motions.present.from < now ? motions.present : motions.before;
    const bool rested = latest.from < grid_from(now) - kPlantStep;
    return {.start = rested ? latest.target : latest.start, .target = latest.target};
  }
  // Motor position as a joint angle at `now`, which is not before the last event [deg].
  [[nodiscard]] double motor_deg(std::size_t axis, Cycles now) const {
    return encoders_[axis].position(now) * joint_deg_per_count_[axis];
  }
  // The angle of each joint less that of its motor, after the step in progress [deg]; none: the gears are rigid.
  [[nodiscard]] std::optional<PerAxis<double>> load_lead_deg() const { return mechanics_->load_lead_deg(); }
  // Reference minus position in the drive, after the step in progress [counts].
  [[nodiscard]] double following_error(std::size_t axis) const { return drives_[axis].following_error(shafts_[axis]); }

 private:
  void drive_pins(Cycles now, const SocOutputs& out);
  void wake(Cycles now);
  void execute_edges(Cycles now);
  void show_count(std::size_t axis);
  // One step of the mechanics: calls `move` with each axis and the position of its motor, which the encoder has not
  // seen yet.
  template <class Move>
  void step_mechanics(Move move) {
    MotorDemands demands;
    for (std::size_t axis = 0; axis < kAxes; ++axis) demands.set(axis, drives_[axis].demand());
    const std::uint8_t stepped = mechanics_->step(moving_, demands, shafts_);
    for_each_bit(stepped, [&, overloaded = mechanics_->overloaded()](std::size_t axis) {
      ServoDrive& drive = drives_[axis];
      drive.observe(shafts_[axis], has_bit(overloaded, axis));
      move(axis, drive.position(shafts_[axis]));
      set_bit(moving_, axis, !drive.idle());
    });
  }
  void step_axes(Cycles now);
  void find_next_event();

  [[nodiscard]] bool can_leave_out(const TickPulses& tick) const;
  bool run_steps(const TickPulses& tick, Cycles spacing);
  bool finishes_step(Cycles now, Cycles spacing);
  [[nodiscard]] bool has_levels_of_inputs(std::size_t axis) const;
  bool follow_steps(std::size_t axis, Cycles spacing);
  bool follow_one_way(std::size_t axis);
  bool follow_each_step(std::size_t axis, Cycles spacing);
  bool shows_no_more_than_lines(std::size_t axis, Counts from, Cycles now, Cycles spacing);
  [[nodiscard]] CountRange quiet_around(std::size_t axis, Counts count) const;
  bool passes_index(std::size_t axis, Counts from, Counts to);
  [[nodiscard]] CountRange counts_in_tick(std::size_t axis, Cycles from) const;

  std::vector<ServoDrive> drives_;  // kAxes, and so on
  std::unique_ptr<Mechanics> mechanics_;
  Shafts shafts_;
  std::vector<IncrementalEncoder> encoders_;
  std::vector<AxisSwitches> switches_;
  PerAxis<double> joint_deg_per_count_;
  SocInputs inputs_;
  std::optional<DropOut> drop_out_;
  SocOutputs seen_;          // servo_on behind the relay
  std::uint8_t moving_ = 0;  // axes that need the next step, one bit each
  PerAxis<int> blocks_{};    // faults that hold the motor
  Cycles next_step_ = kNever;
  PerAxis<Cycles> next_edge_;
  Cycles next_event_ = kNever;
  std::optional<InputViolation> violation_;
  std::optional<PlantTicks> ticks_;  // while edges are left out
};

}  // namespace armature::cosim
