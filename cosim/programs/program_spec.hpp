// The program of a scenario: the key `program` and the tables [gcode] and [job], as the user wrote them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "controller/language/gcode/run/motion_setup.hpp"
#include "cosim/poses/pose_spec.hpp"

namespace armature::cosim {

// [[gcode.analog]]: an analog output as a binary number on pins of the tool.
struct GcodeAnalogSpec {
  std::int64_t number = 0;  // E of M67 and M68
  std::int64_t first_pin = 1;
  std::int64_t bits = 1;
  double full = 1.0;  // the value at which all bits are on
};

// [gcode]
struct GcodeSpec {
  std::string frame_name = "base";
  std::size_t frame = 0;  // 0: the base; n: frames[n - 1]
  gcode::MotionSettings::Orientation orientation = gcode::MotionSettings::Orientation::kKept;
  double rapid_mm_s = 250;
  double rapid_turn_deg_s = 180;
  double accel_mm_s2 = 2'000;
  double turn_accel_deg_s2 = 1'200;
  double corner_mm = 0.5;
  std::int64_t spindle_pin = 0, mist_pin = 0, flood_pin = 0;  // 0: none
  std::vector<std::int64_t> tools;
  std::vector<GcodeAnalogSpec> analog;
};

// [[job.tool]]: a tool of a robot program besides that of the arm, in the flange.
struct JobToolSpec {
  std::int64_t number = 0;  // ///TOOL of the positions
  PoseSpec pose;
};

// The longest run whose length its program decides: [s] of simulated time.
inline constexpr double kLongestProgramRunS = 600;

// [job]
struct JobSpec {
  std::array<double, 8> pl_radius_mm{12.5, 25, 50, 100, 150, 200, 250, 300};  // of PL=1..8
  double accel_mm_s2 = 1'000;
  double turn_accel_deg_s2 = 900;
  std::int64_t arc_pin = 0, weave_pin = 0, tool_pin = 0;  // 0: none
  std::vector<JobToolSpec> tools;
};

// A file of the program, as it was read.
struct ProgramFile {
  std::string name;    // relative to the scenario file, for messages of a run
  std::string file{};  // its path, for messages about its text
  std::string text;
};

}  // namespace armature::cosim
