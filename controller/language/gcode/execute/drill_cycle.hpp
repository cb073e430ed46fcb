// The drilling cycles G73, G74, G81 to G84, a few canonical calls at a time.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/reader/axes6.hpp"

namespace armature::gcode {

// One line with a cycle: holes at the same distance from each other.
struct DrillRequest {
  Axes6 from{};  // place before the line
  Plane plane = Plane::kXy;
  double first = 0.0;  // of the first hole, in the plane
  double second = 0.0;
  double first_step = 0.0;  // from hole to hole
  double second_step = 0.0;
  double clearance = 0.0;  // R, along the normal
  double bottom = 0.0;
  double retract = 0.0;     // after each hole
  double approach = 0.0;    // height of the way to the first hole
  bool rise_first = false;  // to the clearance plane, before anything else
  std::int32_t repeats = 1;
  std::optional<double> dwell_s{};
  double peck = 0.0;  // 0: none
  double peck_clearance = 0.0;
  bool breaks_chips = false;  // the tool stays in the hole from peck to peck
  int tap = 0;                // direction of the spindle: 1 clockwise, -1 counterclockwise; 0: no tapping
  bool feed_override = true;  // on outside of tapping
  bool speed_override = true;
  SetMotionControlMode control{};  // restored at the end
  double naive_cam_mm = 0.0;
};

class DrillCycle {
 public:
  explicit DrillCycle(LineCalls& calls) noexcept : calls_(calls) {}

  // begin() and each step() make at most 12 calls.
  void begin(const DrillRequest& request) noexcept;
  [[nodiscard]] bool active() const noexcept { return phase_ != Phase::kDone; }
  void step() noexcept;
  void abort() noexcept { phase_ = Phase::kDone; }
  [[nodiscard]] const Axes6& place() const noexcept { return place_; }

 private:
  enum class Phase : std::uint8_t { kApproach, kPeck, kRetract, kDone };
  void traverse_to(double height) noexcept;
  void tap() noexcept;
  void turn_spindle(bool clockwise) noexcept;
  void feed_to(double height) noexcept;

  LineCalls& calls_;
  DrillRequest request_{};
  Axes6 place_{};
  Phase phase_ = Phase::kDone;
  std::int32_t hole_ = 0;
  double depth_ = 0.0;  // of the next peck
};

}  // namespace armature::gcode
