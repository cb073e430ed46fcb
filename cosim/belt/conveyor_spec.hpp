// [conveyor] of a scenario, as the user wrote it: the belt, and what the controller knows about it.
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace armature::cosim {

inline constexpr std::string_view kConveyorFrameName = "conveyor";

// [[conveyor.speed]]: the belt changes its speed.
struct BeltSpeedSpec {
  double at_s = 0;
  double speed_mm_s = 0;
};

struct ConveyorSpec {
  // Pose of a part at the sync point, in the base.
  std::array<double, 3> xyz_mm{};
  std::array<double, 3> rpy_deg{};
  std::array<double, 3> direction{1, 0, 0};  // of the belt, in the base; of any length
  double mm_per_count = 0.01;
  std::array<double, 2> window_mm{};  // displacements of the part, ascending
  double max_speed_mm_s = 500;
  double accel_mm_s2 = 2000;
  double speed_tolerance_percent = 10;
  double lead_ms = 0;

  // The motion of the belt.
  double speed_mm_s = 0;              // from the start on
  double belt_accel_mm_s2 = 1000;     // of its changes of speed
  std::vector<BeltSpeedSpec> speeds;  // in the order of time
  double wave_mm = 0;                 // amplitude of the deviation that repeats with each turn of the drum
  double wave_length_mm = 500;        // distance that the belt moves in one turn
  std::vector<double> part_s;         // times at which parts pass the sync point, ascending
};

}  // namespace armature::cosim
