// A scenario and a robot exactly as the user wrote them, validated and in the user's units (those of the key names).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "controller/core/axes.hpp"

namespace armature::cosim {

// ---- robot file (scenarios/robots/<name>.toml) --------------------------------------------------------------------

struct DriveSpec {
  double natural_hz = 40.0;       // natural frequency of the position loop
  double damping = 1.0;           // its damping ratio
  double max_speed_rpm = 3000.0;  // motor speed limit
  double max_torque_nm = 1.27;    // motor torque limit
  double inertia_kg_m2 = 2.0e-4;  // motor plus reflected load inertia
  double min_step_high_ns = 100;  // what the drive's input needs, checked on every pulse
  double min_step_low_ns = 100;
  double dir_setup_ns = 500;
  double dir_hold_ns = 500;
};

// Counts of an encoder line: the decoder counts every edge of both quadrature lines.
inline constexpr std::int32_t kCountsPerLine = 4;

struct AxisSpec {
  double gear_ratio = 50.0;
  std::int32_t pulses_per_rev = 10000;
  std::int32_t encoder_lines = 2500;
  double min_deg = -180, max_deg = 180;
  double max_speed_deg_s = 0, max_accel_deg_s2 = 0;
  double following_error_deg = 5.0;
  DriveSpec drive;
};

struct RobotSpec {
  std::string name;
  std::string description;
  PerAxis<AxisSpec> axes;
};

// ---- scenario file (scenarios/<name>/scenario.toml) ---------------------------------------------------------------

struct ControllerSpec {
  std::string sync = "fig9";  // fig9 | const_acc | time_scale
  bool feedback = true;
};

// What the simulated ARM cores cost, in clock cycles of the logic (20 ns; about 13 CPU cycles at 667 MHz).
struct CpuSpec {
  std::int64_t interrupt_entry_cycles = 50;  // 1 us
  std::int64_t tick_compute_cycles = 250;    // 5 us
  std::int64_t plan_compute_cycles = 2500;   // 50 us
};

struct BusSpec {
  std::int64_t latency_cycles = 6;     // processing-system side, each way
  std::int64_t timeout_cycles = 1000;  // an access that takes longer ends the run
  double stall_probability = 0.0;      // seeded stalls on every channel, per cycle, 0..0.9
};

struct TraceSpec {
  std::int64_t every_ticks = 20;  // 1 = full rate 20 kHz
};

enum class MoveKind { kJoint, kStop, kClearFault };
struct MoveSpec {
  double at_s = 0;
  MoveKind kind = MoveKind::kJoint;
  PerAxis<double> target_deg{};  // joint only
  double speed_percent = 100.0;  // joint only
  int line = 0;                  // in the scenario file, for messages
};

enum class FaultKind {
  kPulseLoss,  // the drive of `axis` does not see the next `count` pulses
  kSlowCore,   // from then on one tick's computation costs `compute_us`
  kEstop,      // estop_ni is low for `duration_s`
};
struct FaultSpec {
  double at_s = 0;
  FaultKind kind = FaultKind::kPulseLoss;
  int axis = 0;            // 1..6
  std::int64_t count = 0;  // pulses
  double compute_us = 0;
  double duration_s = 0;
  int line = 0;
};

// Each present key is one check at the end of the run.
struct ExpectSpec {
  std::optional<std::string> outcome;              // "completed" (default), "fault:<cause>"
  std::optional<PerAxis<double>> final_joint_deg;  // encoder side
  double tolerance_deg = 0.001;
  std::optional<PerAxis<std::int64_t>> total_pulses;        // net pulses counted on the pins
  std::optional<PerAxis<std::int64_t>> final_error_counts;  // reference minus encoder at the end
  std::optional<std::vector<std::int64_t>> move_ticks;      // planned duration of each started move
  std::optional<std::vector<std::string>> profile;          // shapes of the first move, none|triangle|trapezoid
  std::optional<PerAxis<double>> peak_speed_deg_s;          // largest commanded joint speed of the run
  double peak_tolerance_deg_s = 0.001;
  std::optional<std::int64_t> peak_pulses_per_tick;  // largest |count| emitted in one tick, any axis
  std::optional<std::int64_t> underruns;             // exact
  std::optional<std::int64_t> min_underruns;
  std::optional<std::int64_t> refused_moves;
  std::optional<double> settled_within_s;             // after the reference stopped for the last time ...
  std::int64_t settled_counts = 1;                    // ... every encoder stays this close to it
  std::optional<std::int64_t> max_overshoot_counts;   // beyond the final reference, in the direction of motion
  std::optional<std::int64_t> max_correction_pulses;  // largest |feedback correction| of the run, any axis
  std::optional<std::string> stopped_by;              // the last cause why servo enables dropped
  std::optional<std::vector<std::string>> faults;     // causes of all faults that the controller saw, in their order
};

struct GoldenSpec {
  std::optional<std::string> sha256;  // of the full-rate integer columns
};

struct Scenario {
  std::string name;       // folder name
  std::string directory;  // absolute
  std::string file;       // path as given, for messages
  std::string description;
  std::string robot_name;
  RobotSpec robot;
  double duration_s = 0;
  std::uint64_t seed = 1;
  ControllerSpec controller;
  CpuSpec cpu;
  BusSpec bus;
  TraceSpec trace;
  std::vector<MoveSpec> moves;    // in the order of at_s
  std::vector<FaultSpec> faults;  // in the order of at_s
  ExpectSpec expect;
  GoldenSpec golden;
};

}  // namespace armature::cosim
