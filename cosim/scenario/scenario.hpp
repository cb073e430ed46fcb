// A scenario exactly as the user wrote it (scenarios/<name>/scenario.toml), validated and in the user's units (those of
// the key names).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/cell/planning_config.hpp"
#include "cosim/belt/conveyor_spec.hpp"
#include "cosim/bus/bus_spec.hpp"
#include "cosim/cpu/cpu_spec.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/pendant/pendant_spec.hpp"
#include "cosim/poses/pose_spec.hpp"
#include "cosim/programs/program_spec.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/moves/kinds.hpp"
#include "cosim/scenario/pin_spec.hpp"
#include "cosim/scenario/stream_spec.hpp"
#include "cosim/serial/serial_spec.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/input_file.hpp"

namespace armature::cosim {

struct ControllerSpec {
  std::string sync = "fig9";  // fig9 | const_acc | time_scale
  bool feedback = true;
  double max_stretch = PlanningConfig{}.max_stretch;  // the planner's own default
};

// [kinematics]
enum class SetPointSolver : std::uint8_t {
  kSoftware,
  kCordic,  // the block ik_cordic of the logic
};
struct SolverSpec {
  SetPointSolver solver = SetPointSolver::kSoftware;
};

struct TraceSpec {
  std::int64_t every_ticks = 20;  // 1 = full rate 20 kHz
  std::optional<bool> tcp;        // columns of the tool centre point; none: when a move is given as a pose
};

// [[frame]]: a user frame, in the base.
struct FrameSpec {
  std::string name;  // unique, none of kBaseFrameName, kToolFrameName and kConveyorFrameName
  PoseSpec pose;
};

// Each present key is one check at the end of the run.
struct ExpectSpec {
  std::optional<std::string> outcome;              // "completed" (default), "fault:<cause>"
  std::optional<PerAxis<double>> final_joint_deg;  // encoder side
  double tolerance_deg = 0.001;
  std::optional<PerAxis<double>> final_load_deg;  // true angles of the joints
  double load_tolerance_deg = 0.001;
  std::optional<PerAxis<double>> lost_motion_deg;  // of the joints from their motors
  double lost_motion_tolerance_deg = 0.001;
  std::optional<PerAxis<std::int64_t>> total_pulses;        // net pulses counted on the pins
  std::optional<PerAxis<std::int64_t>> final_error_counts;  // reference minus encoder at the end
  std::optional<std::vector<std::int64_t>> move_ticks;      // planned duration of each started move
  std::optional<std::vector<std::int64_t>> taken_ticks;     // duration of each move that reached its end
  std::optional<std::vector<std::string>> profile;          // shapes of the first move, none|triangle|trapezoid
  std::optional<PerAxis<double>> peak_speed_deg_s;          // largest commanded joint speed of the run
  double peak_tolerance_deg_s = 0.001;
  std::optional<std::int64_t> peak_pulses_per_tick;  // largest |count| emitted in one tick, any axis
  std::optional<std::int64_t> underruns;             // exact
  std::optional<std::int64_t> min_underruns;
  std::optional<std::int64_t> missing_ticks;      // triggers that the timer did not give; 0 if not stated
  std::optional<std::int64_t> unanswered_faults;  // injected faults to which nothing responded; 0 if not stated
  std::optional<std::int64_t> max_stop_ticks;     // from an injected fault to the drop of a servo enable
  std::optional<std::int64_t> unasked_stops;      // stops on a path that nobody asked for; 0 if not stated
  std::optional<std::int64_t> refused_moves;
  std::optional<std::int64_t> unfinished_moves;         // moves that still wait or move when the run ends
  std::optional<std::vector<std::string>> jog_ends;     // why each jog ended (JogEnd), in their order
  std::optional<std::vector<std::string>> homing_ends;  // how each axis ended (HomingEnd), in their order
  std::optional<std::int64_t> blended_moves;            // moves that began in a rounded corner
  std::optional<double> min_held_s;                     // least total time that the arm stands in a Hold
  std::optional<std::vector<std::string>> refusals;     // reasons (Refusal) of all refused moves, in their order
  std::optional<double> max_path_error_mm;              // encoder side: tool centre point from the ideal Cartesian path
  std::optional<double> max_command_path_error_mm;      // the same of the set-points
  std::optional<double> max_tool_speed_mm_s, max_tool_accel_mm_s2;  // of the tool centre point, by the set-points
  std::optional<std::array<double, 3>> final_tcp_mm;                // encoder side, base frame
  double tcp_tolerance_mm = 0.01;
  std::optional<std::array<double, 3>> final_rpy_deg;  // of the tool; compared as the angle between the orientations
  double rpy_tolerance_deg = 0.01;
  std::optional<double> max_stretch, min_stretch;            // largest stretch of a move of the run
  std::optional<double> max_residual_deg, min_residual_deg;  // largest deviation of the orientation of a move
  std::optional<double> settled_within_s;                    // after the reference stopped for the last time ...
  std::int64_t settled_counts = 1;                           // ... every encoder stays this close to it
  std::optional<std::int64_t> max_overshoot_counts;          // beyond the final reference, in the direction of motion
  std::optional<std::int64_t> max_correction_pulses;         // largest |feedback correction| of the run, any axis
  // For both variants. All three are 0 for the variant `counts` and an arm that knows its joint angles.
  std::optional<PerAxis<std::int64_t>> inexact_ticks;  // ticks that emitted another count than intended
  std::optional<std::int64_t> max_residual_pulses;     // largest |intended minus emitted count|, any axis
  std::optional<PerAxis<std::int64_t>> lost_counts;    // net counts of the motors that the controller did not see
  std::optional<std::string> stopped_by;               // the last cause why servo enables dropped
  std::optional<std::string> bus_error;                // kBusErrorNames: the first one that stopped a core
  std::optional<std::vector<std::string>> faults;      // causes of all faults that the controller saw, in their order
  std::optional<std::string> serial_sent;  // every byte that the controller sent on the serial line, without an error
  bool serial_as_hex = false;              // given as serial_hex
  std::optional<std::vector<std::string>> streams;        // ends of all streams (StreamEnded::How), in their order
  std::optional<double> max_stream_deviation_deg;         // commanded joints from the streams, any axis
  std::optional<std::vector<std::string>> conveyor_ends;  // why each following of a part ended (PartEnd)
  std::optional<std::int64_t> missed_parts;
  std::optional<std::int64_t> min_corrected_ticks, max_corrected_ticks;      // of [conveyor.policy]
  std::optional<std::int64_t> min_uncorrected_ticks, max_uncorrected_ticks;  // likewise
  std::optional<std::int64_t> min_solved_poses;         // set-points whose joint angles the logic has solved
  std::optional<double> max_solver_difference_pulses;   // their largest difference from software, any axis
  std::optional<double> max_tracking_error_mm;          // encoder side: tool from its path on the part
  std::optional<double> max_command_tracking_error_mm;  // the same of the set-points
  // All changes of the tool's outputs, in their order; each within a tick of its time.
  std::optional<std::vector<OutputChangeSpec>> outputs;
  std::optional<std::vector<std::int64_t>> final_outputs;  // the outputs that are high at the end, ascending
  std::optional<std::string> program_end;                  // kProgramEnds; none: it has ended
  std::optional<std::int64_t> program_end_line;
  std::optional<std::vector<std::string>> program_messages;  // in their order

  // For messages: the scenario file, and the places of the written keys in it.
  std::string file;
  std::map<std::string, Origin, std::less<>> origins;
};

struct GoldenSpec {
  std::optional<std::string> sha256;  // IntegerDigest
};

struct Scenario {
  std::string name;                    // folder name
  std::string directory;               // absolute
  std::string file;                    // path as given, for messages
  std::vector<InputFile> sources;      // all files that the run is made from, this one first
  std::vector<std::string> overrides;  // `--set`, in their order
  std::string description;
  std::string robot_name;
  RobotSpec robot;
  double duration_s = 0;           // with ends_with_program the limit
  bool ends_with_program = false;  // duration_s is not written: the run lasts until its program ends
  std::uint64_t seed = 1;
  bool input_jitter = false;                              // changes of input pins reach the logic up to a clock later
  std::optional<PerAxis<double>> unreferenced_start_deg;  // none: at 0, and the controller knows it
  std::optional<PerAxis<double>> moved_start_deg;         // the same, but the controller takes it to be at 0
  std::optional<double> drop_out_us;  // of the servo power after the last edge of heartbeat_o; none: no drop-out
  Variant variant = Variant::kCounts;
  Engine engine = Engine::kRtl;
  PaperSpec paper;  // with Variant::kPaper
  ControllerSpec controller;
  SolverSpec kinematics;
  CpuSpec cpu;
  BusSpec bus;
  TraceSpec trace;
  PoseSpec tool;                  // of the tool centre point, in the flange
  std::vector<FrameSpec> frames;  // at most kUserFrames
  std::optional<ConveyorSpec> conveyor;
  std::optional<std::string> program;             // relative to the scenario file; none: core 1 executes no program
  std::optional<double> program_at_s;             // its earliest begin; none: 0, or with a pendant when that runs it
  std::optional<double> program_resumes_after_s;  // time after which a pause of it ends; none: nobody ends it
  std::vector<ProgramFile> program_files;         // that file, and those of the jobs that it calls
  GcodeSpec gcode;                                // of a G-code program
  JobSpec job;                                    // of a robot program
  std::vector<CommandSpec> moves;                 // in the order of at_s
  std::vector<StreamSpec> streams;                // in the order of at_s
  std::vector<FaultSpec> faults;                  // in the order of at_s
  std::optional<SerialSpec> serial;               // none: nothing is connected
  std::vector<SerialSendSpec> serial_sends;       // in the order of at_s
  std::optional<PendantSpec> pendant;             // none: the controller does not use its serial line
  std::vector<InputSpec> inputs;                  // in the order of at_s
  ExpectSpec expect;
  GoldenSpec golden;
};

}  // namespace armature::cosim
