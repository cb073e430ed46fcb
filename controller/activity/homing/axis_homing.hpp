// Homing of one axis: the motions that find its joint angle with the home switch and the index pulse of its encoder.
//
//   search    towards the home switch
//   back off  away from it until it is released, if the axis stood on it or met a limit switch first; then search again
//   leave     slowly away from the switch until it is released: the edge
//   index     on in this direction to the first index pulse behind the edge, whose position the logic has latched
//   home      to the home position
//
// Before it turns round, the axis brakes and stands. Each motion is limited to the travel of the axis. All angles and
// counts are those of the controller before homing; shift() converts them.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "controller/message/homing.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/profile/time_law.hpp"
#include "controller/trajectory/state/phase_law.hpp"

namespace armature {

// What the axis shows in a tick.
struct HomingSensors {
  Counts position{};
  bool home = false;
  bool limit_pos = false;
  bool limit_neg = false;
  std::optional<Counts> index{};  // position of the last index pulse; needed only while wants_index()
};

class AxisHoming {
 public:
  // Within this share of a revolution beside the edge, the index is too close to it.
  static constexpr double kEdgeMargin = 0.02;

  explicit AxisHoming(const AxisModel& model) noexcept;

  // For an axis that has a HomingModel and stands at `position`.
  void begin(Radians position) noexcept;
  // Computes the next set-point. Once per tick.
  void advance(const HomingSensors& sensors) noexcept;
  // Brakes with the full acceleration and ends. No effect while braking to the end.
  void stop() noexcept;

  [[nodiscard]] Radians position() const noexcept { return position_; }
  [[nodiscard]] bool wants_index() const noexcept { return phase_ == Phase::kIndex; }
  // The axis stands, and does no more.
  [[nodiscard]] bool over() const noexcept { return phase_ == Phase::kOver; }
  [[nodiscard]] double speed() const noexcept;  // of the set-point, without sign
  // A motion was planned in the last advance().
  [[nodiscard]] bool planned() const noexcept { return ticks_ == 1; }

  // Valid when over().
  [[nodiscard]] HomingEnd how() const noexcept { return how_; }
  [[nodiscard]] HomingSwitch reached_switch() const noexcept { return reached_switch_; }
  [[nodiscard]] Counts edge_to_index() const noexcept { return edge_to_index_; }
  // To be added to the counts of the encoder.
  [[nodiscard]] Counts shift() const noexcept { return shift_; }

 private:
  enum class Phase : std::uint8_t { kFirst, kSearch, kBackOff, kLeave, kIndex, kHome, kBrake, kOver };

  void react(const HomingSensors& sensors) noexcept;
  void start(const HomingSensors& sensors) noexcept;
  void search(const HomingSensors& sensors) noexcept;
  void back_off(const HomingSensors& sensors) noexcept;
  void leave(const HomingSensors& sensors) noexcept;
  void find_index(const HomingSensors& sensors) noexcept;
  void go_home(const HomingSensors& sensors) noexcept;
  void reach(HomingSwitch what) noexcept;
  void begin_phase(Phase phase) noexcept;
  void move(double direction, double speed) noexcept;
  void move_to(double target, double speed) noexcept;
  void brake_before(Phase next) noexcept;
  void fail(HomingEnd how) noexcept;
  [[nodiscard]] bool left_switch(const HomingSensors& sensors) noexcept;
  [[nodiscard]] bool limit_ahead(const HomingSensors& sensors) const noexcept;
  [[nodiscard]] bool law_over() const noexcept;
  [[nodiscard]] bool stands(Counts measured) noexcept;

  HomingModel model_;
  AxisUnits units_;
  std::int64_t counts_per_rev_;
  double travel_rad_;
  TimeLawLimits limits_;
  Phase phase_ = Phase::kOver;
  Phase next_ = Phase::kOver;  // after kBrake
  PhaseLaw law_{};
  std::int64_t ticks_ = 0;  // since the start of the law
  double direction_ = 1.0;  // of the motion
  Radians position_{};
  bool on_switch_ = false;  // the switch was active since the axis moves away from it
  Counts still_at_{};       // where the encoder has been for `still_ticks_`, within a count
  std::int64_t still_ticks_ = 0;
  Counts edge_{};
  HomingEnd how_ = HomingEnd::kStop;
  HomingSwitch reached_switch_ = HomingSwitch::kNone;
  Counts edge_to_index_{};
  Counts shift_{};
};

}  // namespace armature
