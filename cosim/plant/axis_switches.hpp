// The home switch and the two limit switches of an axis. A switch is active where the encoder shows a joint angle in
// its range: the home switch between two angles, a limit switch from its angle to the end of the travel.
#pragma once

#include <array>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/robot/robot_spec.hpp"

namespace armature::cosim {

class AxisSwitches {
 public:
  AxisSwitches(const AxisSpec& spec, double joint_deg_per_count)
      : home_deg_{spec.home_switch_deg}, limits_deg_{spec.limit_switch_deg}, deg_per_count_{joint_deg_per_count} {}

  // Whether every switch has one level at all counts between the two, which are not far apart.
  [[nodiscard]] bool are_steady(Counts from, Counts to) const {
    return home(from) == home(to) && limit_neg(from) == limit_neg(to) && limit_pos(from) == limit_pos(to) &&
           (!home_deg_ || home(from) || (deg(from) < home_deg_->front()) == (deg(to) < home_deg_->front()));
  }

  [[nodiscard]] bool home(Counts count) const {
    return home_deg_ && deg(count) >= home_deg_->front() && deg(count) <= home_deg_->back();
  }
  [[nodiscard]] bool limit_neg(Counts count) const { return limits_deg_ && deg(count) <= limits_deg_->front(); }
  [[nodiscard]] bool limit_pos(Counts count) const { return limits_deg_ && deg(count) >= limits_deg_->back(); }

 private:
  [[nodiscard]] double deg(Counts count) const { return static_cast<double>(count.value()) * deg_per_count_; }

  std::optional<std::array<double, 2>> home_deg_;
  std::optional<std::array<double, 2>> limits_deg_;
  double deg_per_count_;
};

}  // namespace armature::cosim
