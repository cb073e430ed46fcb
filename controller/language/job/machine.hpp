// Executes encoded jobs: the virtual machine of the robot language.
//
// A step executes one record. Moves, dwells and outputs are sent ahead of the arm through the port. What depends on the
// state of the cell waits until all of that is over: inputs and outputs that are read, PULSE, GETS of the present
// position, PAUSE, and an alarm. So does a target that the joints at the end of a path decide: IMOV by joints, a
// posture at a singularity, and a joint move to a posture that several whole turns reach. Arithmetic, jumps and MSG are
// executed ahead, too.
//
// Units: V= is mm/s, VJ= percent, VR= deg/s, T= seconds. As variables they are 0.1 mm/s, 0.01 %, 0.1 deg/s and 0.01 s.
// Elements of positions in SETE, GETE and calculations are 0.001 mm and 0.0001 deg, or pulses.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/language/job/alarm.hpp"
#include "controller/language/job/machine_setup.hpp"
#include "controller/language/job/program_memory.hpp"
#include "controller/language/job/variables.hpp"
#include "controller/language/program/interpreter.hpp"

namespace armature::job {

class Machine final : public Interpreter {
 public:
  static constexpr std::size_t kPins = 16;  // inputs and outputs of the arm; outputs beyond have a level only
  static constexpr std::size_t kMostOutputs = 4'096;

  // References must outlive the machine. All jobs of the memory must be loaded and linked.
  Machine(const ProgramMemory& memory, const MachineSetup& setup) noexcept : memory_{memory}, setup_{setup} {}

  // What start() begins with: a job, from its first instruction at or behind a line.
  void select(std::size_t job, std::uint32_t line = 0) noexcept;

  // Interpreter
  void start() noexcept override;
  [[nodiscard]] Progress step(ProgramPort& port) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override { return waits_for_time_; }
  // Of the job that select() has named. False also for a line behind its last instruction.
  [[nodiscard]] bool select_line(std::uint32_t line) noexcept override;
  [[nodiscard]] bool has_line(ProgramPlace place) const noexcept override;
  void set_single_step(bool on) noexcept override { single_step_ = on; }

  [[nodiscard]] Alarm alarm() const noexcept { return alarm_; }
  [[nodiscard]] Variables& variables() noexcept { return variables_; }
  // The job and the line of the next instruction.
  [[nodiscard]] std::size_t job() const noexcept { return job_; }
  [[nodiscard]] std::uint32_t line() const noexcept;

  // A place is a job in the upper 8 bits and a line in the lower 16.
  [[nodiscard]] static constexpr ProgramPlace place_of(std::size_t job, std::uint32_t line) noexcept {
    return static_cast<ProgramPlace>(job << 16U | line);
  }
  [[nodiscard]] static constexpr std::size_t job_of(ProgramPlace place) noexcept { return place >> 16U; }
  [[nodiscard]] static constexpr std::uint32_t line_of(ProgramPlace place) noexcept { return place & 0xFFFFU; }

 private:
  static constexpr std::size_t kMostArguments = 8;
  enum class Outcome : std::uint8_t { kNext, kJumped, kWait, kPause, kEnd, kAlarm };
  // A move with UNTIL, once it was sent.
  enum class Until : std::uint8_t { kNone, kMoving, kStopping };
  struct Argument {
    bool is_position = false;
    double number = 0.0;
    PositionValue position{};
  };
  struct CallFrame {
    std::uint16_t job = 0, return_to = 0;
    std::size_t argument_count = 0;
    std::array<Argument, kMostArguments> arguments{};
  };
  // The place of the arm at the end of what was sent, as far as it is known.
  struct Planned {
    std::optional<JointAngles> joints{};
    std::optional<Transform> base_T_tool{};
  };
  // The tags of a move or of SPEED, as numbers in the units of the program.
  struct MoveTags {
    std::optional<double> vj, v, vr, pl, cr, acc, dec;
  };

  // Operands (machine_operands.cpp). `at` moves behind what was read. False: outcome_ says why not.
  [[nodiscard]] const Operand& operand(std::size_t at) const noexcept { return operands_[at]; }
  [[nodiscard]] bool is_word(std::size_t at, Word word) const noexcept;
  void skip(std::size_t& at) const noexcept;
  [[nodiscard]] bool number(std::size_t& at, double& value) noexcept;
  [[nodiscard]] bool pin_value(std::size_t& at, double& value) noexcept;
  [[nodiscard]] bool tag_number(std::size_t& at, double unit, double& value) noexcept;
  [[nodiscard]] bool expression(std::size_t& at, double& value) noexcept;
  [[nodiscard]] bool condition(std::size_t& at, bool& holds) noexcept;
  [[nodiscard]] bool comparison(std::size_t& at, bool& holds) noexcept;
  [[nodiscard]] bool guard(std::size_t at, bool& holds) noexcept;
  [[nodiscard]] bool variable(std::size_t& at, VariableId& id) noexcept;
  [[nodiscard]] PositionValue* position_variable(std::size_t& at) noexcept;
  [[nodiscard]] bool is_position_variable(std::size_t at) const noexcept;
  [[nodiscard]] bool fail(Alarm alarm) noexcept;
  [[nodiscard]] bool check(Alarm alarm) noexcept { return alarm == Alarm::kNone || fail(alarm); }
  [[nodiscard]] bool wait_until_done(bool timed = false) noexcept;

  // Data (machine_data.cpp, machine_positions.cpp).
  [[nodiscard]] Outcome calculate() noexcept;
  [[nodiscard]] Outcome calculate_position(std::size_t at, PositionValue& result) noexcept;
  [[nodiscard]] Outcome assign() noexcept;
  [[nodiscard]] Outcome clear() noexcept;
  [[nodiscard]] Outcome set_element() noexcept;
  [[nodiscard]] Outcome get_element() noexcept;
  [[nodiscard]] Outcome get_system() noexcept;
  [[nodiscard]] Outcome convert() noexcept;
  [[nodiscard]] Outcome make_frame() noexcept;
  [[nodiscard]] Outcome get_argument() noexcept;

  // Flow (machine_flow.cpp).
  [[nodiscard]] Outcome execute() noexcept;
  [[nodiscard]] Outcome execute_flow(Op op) noexcept;
  [[nodiscard]] Outcome go_to(std::uint16_t record) noexcept;
  [[nodiscard]] Outcome branch() noexcept;
  [[nodiscard]] Outcome select_case() noexcept;
  [[nodiscard]] Outcome next_loop() noexcept;
  [[nodiscard]] Outcome loop(bool first) noexcept;
  [[nodiscard]] Outcome jump() noexcept;
  [[nodiscard]] Outcome call() noexcept;
  [[nodiscard]] Outcome return_value() noexcept;
  [[nodiscard]] Outcome return_from_job() noexcept;
  [[nodiscard]] Outcome guarded(Outcome outcome) noexcept;
  [[nodiscard]] Alarm enter_job(std::size_t job) noexcept;
  [[nodiscard]] Outcome raise_user_alarm() noexcept;
  [[nodiscard]] Outcome show_message() noexcept;

  // Time and pins (machine_pins.cpp).
  [[nodiscard]] Outcome dwell() noexcept;
  [[nodiscard]] Outcome wait() noexcept;
  [[nodiscard]] Outcome switch_outputs() noexcept;
  [[nodiscard]] Outcome switch_output(std::size_t pin, bool level) noexcept;
  [[nodiscard]] Outcome read_inputs() noexcept;
  [[nodiscard]] Outcome begin_pulse() noexcept;

  // Motion (machine_motion.cpp, machine_paths.cpp, machine_postures.cpp).
  [[nodiscard]] Outcome move() noexcept;
  [[nodiscard]] Outcome move_joints(const PositionValue& target, const MoveTags& tags) noexcept;
  [[nodiscard]] Outcome move_path(const PositionValue& target, const MoveTags& tags) noexcept;
  [[nodiscard]] Outcome move_on_spline() noexcept;
  [[nodiscard]] Outcome move_relative() noexcept;
  [[nodiscard]] Outcome send_move() noexcept;
  [[nodiscard]] std::size_t until_at() const noexcept;
  [[nodiscard]] Outcome move_until() noexcept;
  [[nodiscard]] bool input_reached(bool& reached) noexcept;
  [[nodiscard]] Outcome set_speeds() noexcept;
  [[nodiscard]] Outcome set_shift() noexcept;
  [[nodiscard]] Outcome send_path(CartesianMove& move, const MoveTags& tags, const Transform& base_T_tool) noexcept;
  [[nodiscard]] static double share_of_acceleration(const MoveTags& tags) noexcept;
  [[nodiscard]] bool read_tags(std::size_t at, MoveTags& tags) noexcept;
  [[nodiscard]] bool position_of(std::uint16_t record, PositionValue& target) noexcept;
  [[nodiscard]] bool move_target(std::size_t& at, PositionValue& target) noexcept;
  // What pose_at() solves where a posture is stated. A path decides itself about whole turns, so it needs the sides
  // only.
  enum class Solve : std::uint8_t { kNothing, kSides, kJoints };
  // The tool of the arm at a position, with the shift. `joints`: those that the position states and, unless kNothing,
  // those of its posture.
  [[nodiscard]] bool pose_at(const PositionValue& target, Transform& base_T_tool, std::optional<JointAngles>& joints,
                             Solve solve) noexcept;
  [[nodiscard]] bool solve_posture(const Transform& base_T_tool, std::uint8_t posture, Solve solve,
                                   std::optional<JointAngles>& joints) noexcept;
  // Of a joint move. Without `joints` the arm reaches the pose with those nearest to where it will be.
  [[nodiscard]] bool target_of(const PositionValue& target, std::optional<JointAngles>& joints,
                               Transform& base_T_tool) noexcept;
  [[nodiscard]] static Transform pose_of(const PositionValue& position) noexcept;
  [[nodiscard]] bool arc_middle(std::uint16_t record, const Transform& target,
                                std::optional<Eigen::Vector3d>& via_mm) noexcept;
  [[nodiscard]] bool know_joints() noexcept;
  [[nodiscard]] bool know_pose() noexcept;
  [[nodiscard]] bool frame_at(std::size_t& at, Transform& base_T_frame) noexcept;
  [[nodiscard]] bool frame_of(Frame frame, double user, Transform& base_T_frame) noexcept;
  // Tools (machine_tools.cpp).
  [[nodiscard]] bool use_tool(std::uint8_t tool) noexcept;
  [[nodiscard]] const Transform* stated_tool(std::uint8_t tool) const noexcept;  // null: the settings state none
  [[nodiscard]] Transform arm_T_tool(std::uint8_t tool) const noexcept;  // from the tool of the arm to another one
  [[nodiscard]] bool keeps_tool_path(const Transform& base_T_tool) noexcept;
  [[nodiscard]] Transform tool_at(const JointAngles& joints) const noexcept;
  [[nodiscard]] PositionValue cartesian_value(const Transform& frame_T_tool, Frame frame, std::uint8_t user,
                                              const PositionValue& like) const noexcept;

  [[nodiscard]] Progress finish(Outcome outcome) noexcept;
  void note(ProgramNote::Kind kind, std::string_view first, std::string_view second = {}) noexcept;
  [[nodiscard]] const Record& record(std::uint16_t at) const noexcept {
    return memory_.records[memory_.jobs[job_].first_record + at];
  }
  [[nodiscard]] const Record& here() const noexcept { return record(pc_); }
  [[nodiscard]] ProgramPlace place() const noexcept { return place_of(job_, here().line); }

  const ProgramMemory& memory_;
  MachineSetup setup_;
  Variables variables_;
  ProgramPort* port_ = nullptr;  // during a step
  std::span<const Operand> operands_{};

  std::size_t first_job_ = 0;
  std::uint32_t first_line_ = 0;
  std::size_t job_ = 0;
  std::uint16_t pc_ = 0;
  std::array<CallFrame, Variables::kMostCalls + 1> calls_{};
  std::size_t depth_ = 0;  // of calls_; 1: the first job
  double returned_ = 0.0;
  Alarm alarm_ = Alarm::kNone;
  Outcome outcome_ = Outcome::kNext;  // why an operand could not be read
  bool begun_ = false;                // the record here: its line was noted
  bool pause_when_done_ = false;
  bool paused_here_ = false;  // before the record here: a breakpoint does not pause once more
  bool single_step_ = false;
  bool waits_for_time_ = false;
  Until until_ = Until::kNone;
  bool needs_joints_ = false;  // the record here waits for the joints before it

  double joint_speed_ = 0.1, speed_mm_s_ = 0.0, turn_speed_rad_s_ = 0.0;
  std::optional<Transform> base_shift_{}, tool_shift_{};  // of SFTON: left and right factor
  std::optional<Eigen::Vector3d> shift_mm_{};
  std::optional<std::uint8_t> tool_{};      // the number of the present tool
  std::optional<std::uint8_t> arm_tool_{};  // the number by which the program names the tool of the arm
  Planned planned_{};

  std::optional<Ticks> wait_began_{};
  std::size_t group_bit_ = 0;                // of DOUT of a group: the next one
  std::bitset<kMostOutputs + 1> outputs_{};  // beyond kPins
};

}  // namespace armature::job
