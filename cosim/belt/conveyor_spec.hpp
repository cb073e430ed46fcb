// [conveyor] of a scenario, as the user wrote it: the belt, and what the controller knows about it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/cell/belt_policy_config.hpp"

namespace armature::cosim {

inline constexpr std::string_view kConveyorFrameName = "conveyor";

// [[conveyor.speed]]: the belt changes its speed.
struct BeltSpeedSpec {
  double at_s = 0;
  double speed_mm_s = 0;
};

// [conveyor.camera]: a camera measures where the belt is, instead of an encoder.
struct BeltCameraSpec {
  double period_ms = 20;
  double dead_time_ms = 40;
  double noise_mm = 0.2;             // standard deviation of a sample
  std::array<double, 2> hidden_s{};  // no sample is taken from the first time to the second one
};

// [conveyor.policy]: a network corrects where the belt is expected.
struct BeltPolicySpec {
  std::string file_name;  // as written, relative to the scenario
  BeltPolicyConfig::Where on = BeltPolicyConfig::Where::kLogic;
  double percent = 100;        // of the largest correction of the network
  BeltPolicyConfig network{};  // of the file; not `where` and `share`
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
  std::optional<BeltCameraSpec> camera{};  // none: an encoder
  std::optional<BeltPolicySpec> policy{};  // none: no network

  // The motion of the belt.
  double speed_mm_s = 0;              // from the start on
  double belt_accel_mm_s2 = 1000;     // of its changes of speed
  std::vector<BeltSpeedSpec> speeds;  // in the order of time
  double wave_mm = 0;                 // amplitude of the deviation that repeats with each turn of the drum
  double wave_length_mm = 500;        // distance that the belt moves in one turn
  std::vector<double> part_s;         // times at which parts pass the sync point, ascending
};

}  // namespace armature::cosim
