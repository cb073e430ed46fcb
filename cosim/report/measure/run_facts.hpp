// The measurements of a run, collected tick by tick without storing the trace.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/event.hpp"
#include "controller/message/telemetry.hpp"
#include "cosim/report/measure/demanded_stops.hpp"
#include "cosim/report/measure/injections.hpp"
#include "cosim/report/measure/path_error.hpp"
#include "cosim/report/measure/run_events.hpp"
#include "cosim/report/measure/run_place.hpp"
#include "cosim/report/measure/tool_motion.hpp"
#include "cosim/report/measure/tracking_error.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// An orientation that is missed by less is not reported: by rounding, or where a path passes the wrist singularity
// within BendLayout::kHair_rad.
inline constexpr double kNoDeviationDeg = 6e-5;

// "Reference" and "encoder" are the values of the controller, as golden traces show them. Both are in encoder counts;
// the reference is rounded to whole pulses first.
struct RunFacts {
  std::size_t axis_count = kAxes;                  // of the robot; the elements of the arrays for other axes are unused
  std::optional<PerAxis<double>> moved_start_deg;  // of the scenario
  std::int64_t ticks = 0;                          // rows seen, one for each trigger
  std::optional<RunPlace> first_trigger_at, last_trigger_at;
  // Of the whole simulation. The run (cosim/run) sets them at its end.
  Cycles cycles{};  // simulated
  std::int64_t bus_reads = 0;
  std::int64_t bus_writes = 0;
  Cycles worst_tick{};  // longest time that core 0 needed for one tick
  std::string sha256;   // IntegerDigest of the run

  std::vector<MoveStarted> moves;
  std::vector<RefusedMove> refusals;
  std::vector<JogRun> jogs;
  std::vector<HomingRun> homings;
  std::vector<FaultEvent> faults;
  std::vector<Cycles> resets;              // the controller left Fault
  std::optional<RunPlace> servo_off_at{};  // the last drop of all servo enables
  std::vector<OtherEvent> other_events;
  std::vector<BusAbortEvent> bus_aborts;
  FaultCause end_fault = FaultCause::kNone;  // kNone: the controller is not in Fault at the end
  bool controller_silent = false;            // servo enables are low at the end, and the controller is not in Fault
  DemandedStops stops;
  std::string stopped_by;           // the last cause (kCauses) why servo enables dropped; or empty
  std::int64_t moves_finished = 0;  // of those started
  // Of the moves of the scenario and its commands for pins of the tool, at the end of the run. A waiting command
  // was sent to the controller, and the controller has neither begun nor refused it. A move under way has begun and has
  // not reached its end, and no stop and no fault has cut it short.
  std::int64_t moves_waiting = 0;
  std::int64_t moves_under_way = 0;
  bool planning = false;  // a move waits at the end because core 1 computes: it was busy in the whole last tick
  // The ticks of moves[i] from its start to its end. Without holds and overrides they are moves[i].duration. None: the
  // move is under way, or a stop or a fault has cut it short.
  std::vector<std::optional<std::int64_t>> taken_ticks;
  std::vector<std::uint32_t> blends_asked_for;  // tags of the moves with a blend radius

  PerAxis<double> final_joint_deg{};            // from the last encoder count
  PerAxis<std::int64_t> total_pulses{};         // net, on the pins
  PerAxis<std::int64_t> final_error_counts{};   // reference minus encoder
  PerAxis<double> peak_speed_deg_s{};           // of the reference, mean over a tick, outside Fault
  PerAxis<std::int64_t> overshoot_counts{};     // encoder beyond the final reference since the axis last reversed
  PerAxis<double> worst_following_error_deg{};  // |reference - encoder|, as joint angles, outside Fault
  // With elastic gears: the true angle of each joint at the end, and the range of the angle of the joint less that of
  // its motor, between the triggers of the run.
  std::optional<PerAxis<double>> final_load_deg, lost_motion_deg;
  std::int64_t peak_pulses_per_tick = 0;   // on the pins, any axis
  std::int64_t max_correction_pulses = 0;  // |feedback correction|, any axis
  std::int64_t underruns = 0;
  // Of core 0 in one tick, by MotionState; all 0: the processor does not count them. The place: of the largest of all.
  std::array<std::int64_t, kWordsOf<MotionState>.size()> most_instructions{};
  std::optional<RunPlace> most_instructions_at;
  [[nodiscard]] bool counts_instructions() const { return most_instructions_at.has_value(); }
  // The row in which each of these values was reached first; none: it never was above 0.
  PerAxis<std::optional<RunPlace>> peak_speed_at{}, overshoot_at{}, worst_following_error_at{};
  std::optional<RunPlace> peak_pulses_at, max_correction_at, max_residual_at;
  std::optional<RunPlace> first_underrun_at;  // as the controller noticed it
  std::optional<RunPlace> last_outside_at;    // the last row with an encoder outside the settling band
  // Outside Fault: the ticks that emitted another count than the controller intended, and the largest
  // |intended minus emitted| after a tick, of any axis. The logic adds this residual to the next ticks.
  PerAxis<std::int64_t> inexact_ticks{};
  std::int64_t max_residual_pulses = 0;
  // Net counts that the motor has moved by the end of the run and that the controller has not seen. The controller sees
  // the counts of the last trigger but one, so this is 0 at rest if the logic decodes every encoder.
  PerAxis<std::int64_t> lost_counts{};
  bool moved = false;  // the reference has changed
  double held_s = 0;   // the set-points stood still in a Hold, in all
  // From the last change of the reference until every encoder stays within the settling band. None: it never does, or
  // the reference never moved.
  std::optional<double> settle_s;
  std::int64_t settled_counts = 1;  // half width of that band

  // None: no row had the tool centre point, or there was no path.
  std::optional<Eigen::Vector3d> final_tcp_mm;      // encoder side, base frame
  std::optional<Eigen::Matrix3d> final_rotation;    // of the tool, likewise
  std::optional<PathDeviation> path_error;          // encoder side
  std::optional<PathDeviation> command_path_error;  // of the set-points
  std::optional<ToolPeak> peak_tool_speed_mm_s, peak_tool_accel_mm_s2;

  std::string serial_sent;         // bytes that the controller sent on the serial line
  std::int64_t serial_errors = 0;  // bytes of them with an error, and breaks, which are no bytes

  std::vector<std::string> streams;        // StreamEnded::How: how each stream ended, in the order of time
  PerAxis<double> stream_deviation_deg{};  // largest distance of the commanded joints from the streams

  std::vector<std::string> conveyor_ends;  // PartEnd: why each following of a part ended, in the order of time
  std::int64_t missed_parts = 0;
  std::int64_t corrected_ticks = 0;                     // of the followed parts: by the network of [conveyor.policy]
  std::int64_t uncorrected_ticks = 0;                   // in which it gave no result, or was not asked
  std::int64_t solved_poses = 0;                        // by the logic
  double solver_difference_pulses = 0;                  // largest, of their joint angles from software
  std::optional<PathDeviation> tracking_error;          // of the encoders
  std::optional<PathDeviation> command_tracking_error;  // of the set-points
  std::optional<double> rms_tracking_error_mm;          // of the encoders
  std::optional<double> rms_command_tracking_error_mm;  // of the set-points

  CommandNames names;                        // for messages about commands
  std::vector<ProgramEvent> program_events;  // in the order of time

  std::vector<OutputChange> outputs;  // likewise

  std::vector<InjectedFault> injected_faults;  // likewise
  std::vector<GivenInput> inputs;              // likewise

  // How the program ended: one of kProgramEnds; empty: there is none.
  [[nodiscard]] std::string_view program_end() const;
  // The event that ended it, or its last one; null: it did not begin.
  [[nodiscard]] const ProgramEvent* program_last() const;
  // Its line at that event; of a program that is running, the line of the last move that has begun.
  [[nodiscard]] std::optional<std::uint32_t> program_place() const;
  [[nodiscard]] std::vector<std::string> program_messages() const;
  // The tool's outputs that are high at the end, ascending.
  [[nodiscard]] std::vector<std::int64_t> high_outputs() const;
  [[nodiscard]] double max_stream_deviation_deg() const;
  [[nodiscard]] std::int64_t blended_moves() const;
  [[nodiscard]] std::int64_t unasked_stops() const;  // MoveStarted::unasked_stop
  // The move with the largest stretch for the limits of the joints (null: no move began), and its factor, >= 1.
  [[nodiscard]] const MoveStarted* most_stretched() const;
  [[nodiscard]] double largest_stretch() const;
  // The largest planned deviation of the tool's orientation of all moves.
  [[nodiscard]] double largest_residual_deg() const;
  // Whether moves[i] led into the next move without a stop. Nullopt: it stopped, and the scenario did not ask for a
  // blend; or it did not reach its end.
  [[nodiscard]] std::optional<bool> blended_with_next(std::size_t i) const;
  // Triggers that the simulated time has room for and that did not come.
  [[nodiscard]] std::int64_t missing_ticks() const;
  [[nodiscard]] std::int64_t unanswered_faults() const;
  [[nodiscard]] std::optional<std::int64_t> stop_ticks() const;  // the longest of injected_faults
  // A stop that was demanded and not executed in time.
  [[nodiscard]] std::optional<DemandedStop> missed_stop() const { return stops.missed(cycles); }
  [[nodiscard]] std::string_view outcome() const;    // one of outcomes()
  [[nodiscard]] std::string_view bus_error() const;  // of the first abort, one of kBusErrorNames
  [[nodiscard]] double simulated_s() const;
};

class RunFactsCollector {
 public:
  // `settled_counts`: half width of the settling band.
  RunFactsCollector(const RobotSpec& robot, std::int64_t settled_counts,
                    const std::optional<ConveyorSpec>& conveyor = {}, CommandNames names = {});

  // The scenario gives this move to the controller.
  void add(const CommandSpec& given);
  void add(const TraceRow& row);
  void add_tool(const TraceRow& row, const Eigen::Vector3d& set_point_mm) { tool_motion_.add(row, set_point_mm); }
  void on_event(const Event& event, Cycles at);  // before the row of its tick
  void add(OutputChange change);
  void add_servo_enables(std::uint8_t levels, Cycles at);  // those at the drives changed
  // An action of the scenario on the system.
  void add(const FaultSpec& fault, const RunPlace& when);
  void add(const InputSpec& input, const RunPlace& when) { injections_.add(input, when); }
  void add(const BusAbortEvent& abort);
  void end(const FaultSpec& fault, Cycles at) { injections_.end(fault, at); }
  // The controller sends a byte, or a break, on the serial line.
  void add_serial(std::uint8_t byte, bool error, bool is_break);

  // The controller takes the arm to be at 0, and it stands here.
  void set_moved_start(const PerAxis<double>& deg) { facts_.moved_start_deg = deg; }
  // The relay of the servo power opens after this time.
  void set_drop_out(Cycles time) { facts_.stops.set_drop_out(time); }

  // The facts of all rows so far.
  [[nodiscard]] RunFacts facts() const;
  // Of them; it costs no copy.
  [[nodiscard]] const std::vector<FaultEvent>& faults() const { return facts_.faults; }

 private:
  struct Axis {
    double counts_per_pulse = 1;
    double counts_per_turn = 1;  // of the joint; signed like the gear ratio
    std::int64_t direction = 0;  // of the reference's last change, in counts: -1, 0, 1
    std::int64_t farthest = 0;   // largest encoder value since the last change of direction, times direction
    RunPlace farthest_at;
    double largest_step_rad = 0;  // of the reference in a tick, outside Fault
  };
  void add(const MoveStarted& move);
  void add(const ProgramNoted& note, Cycles at);
  void no_longer_waits(Tag tag);
  void add(const MoveFinished& move);
  void add(const HomingEnded& axis);
  void add(const StreamEnded& stream);
  void add(const PartFollowed& part);
  struct RowNews {
    bool reference_moved = false;
    std::size_t outside = 0;  // number of the last axis outside the settling band; 0: none
  };
  RowNews add_axes(const TraceRow& row);
  void add_instructions(const TraceRow& row);
  void add_load_lead(const PerAxis<double>& lead_deg);
  void add_step(const TraceRow& row, std::size_t i, double step_rad, bool faulty);
  [[nodiscard]] bool is_outside(const Telemetry& telemetry, std::size_t i) const;         // the settling band
  [[nodiscard]] double exact_reference(const Telemetry& telemetry, std::size_t i) const;  // [counts]
  [[nodiscard]] std::int64_t reference_counts(const Telemetry& telemetry, std::size_t i) const;

  PerAxis<Axis> axes_{};
  std::optional<PerAxis<double>> least_lead_deg_, most_lead_deg_;  // of the joints before their motors
  RunFacts facts_;
  PathErrorMeter path_error_;
  ToolMotionMeter tool_motion_;
  std::optional<TrackingErrorMeter> tracking_error_;  // with a conveyor
  InjectionMeter injections_;
  TraceRow last_;
  std::optional<Eigen::Vector3d> tool_before_;  // of the set-points of the row before
  std::vector<std::uint32_t> waiting_;          // tags of what moves_waiting counts
  std::size_t over_ = 0;                        // of facts_.moves: so many have reached their end or were cut short
  bool stopped_ = false;                        // all servo enables have dropped
  bool servo_off_ = false;                      // all are low and were not before
  bool in_fault_ = false;                       // of the controller, as it reports
  FaultCause stop_cause_ = FaultCause::kNone;   // with which it entered Fault the last time
  std::int64_t reference_moved_tick_ = 0;       // last tick in which the reference changed
  std::int64_t outside_tick_ = -1;              // last tick with an encoder outside the band, or before the change
};

}  // namespace armature::cosim
