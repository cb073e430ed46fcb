// Executes the blocks of a program in the order that the language defines, and makes the canonical calls.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/language/gcode/block.hpp"
#include "controller/language/gcode/canon.hpp"
#include "controller/language/gcode/drill_cycle.hpp"
#include "controller/language/gcode/offsets.hpp"
#include "controller/language/gcode/parameters.hpp"

namespace armature::gcode {

inline constexpr int kSystems = 9;

class Executor final : public ComputedParameters {
 public:
  // What the program does next.
  enum class After : std::uint8_t { kNext, kStop, kWaitInput, kEnd };

  explicit Executor(CanonSink& sink) noexcept : sink_(sink), parameters_(*this) {}

  // Forgets modes, names and places: `machine` is where the tool is, in coordinates of the machine. Offsets of
  // coordinate systems and tools stay. Makes the calls of the start.
  void begin_program(const Axes6& machine) noexcept;

  // What stays from program to program: parameters from 5001 on, and tools.
  struct Stored {
    std::array<double, Parameters::kLast + 1 - kFirstStored> parameters{};
    std::array<std::optional<Axes6>, kMaxTools> tools{};
  };
  void save(Stored& stored) const noexcept;
  void restore(const Stored& stored) noexcept;

  // Executes a block. An error has neither a line nor, mostly, a column.
  [[nodiscard]] std::optional<Error> execute(Block& block, std::uint32_t line) noexcept;
  // The rest of a drilling cycle. A block that begins one continues here; each call makes a few canonical calls.
  [[nodiscard]] bool in_cycle() const noexcept { return cycle_.active(); }
  void continue_cycle() noexcept;
  [[nodiscard]] After after() const noexcept { return after_; }
  // The value of an input that WaitInput asked for.
  void give_input(double value) noexcept { parameters_.at(kInputParameter) = value; }
  void say(Text::Kind kind, std::string_view text, std::uint32_t line) noexcept;
  // A subroutine or a subprogram begins and ends.
  void begin_call() noexcept;
  void end_call() noexcept;
  // The line whose values are read: #<_line>.
  void begin_line(std::uint32_t line) noexcept { line_ = line; }
  // The end of the program, as with M2.
  void end(std::uint32_t line) noexcept;

  // Adds a tool, 1..kMaxTools - 1, to the tool table. It stays for all programs.
  void add_tool(int number, const Axes6& offset) noexcept { tools_[static_cast<std::size_t>(number)] = offset; }
  // The same for several, without an offset.
  void add_tools(const ToolNumbers& numbers) noexcept {
    for (int number = 1; number < kMaxTools; ++number) {
      if (numbers[static_cast<std::size_t>(number)]) add_tool(number, {});
    }
  }

  [[nodiscard]] Parameters& parameters() noexcept { return parameters_; }
  [[nodiscard]] const Offsets& offsets() const noexcept { return offsets_; }
  void set_returned(std::optional<double> value) noexcept { returned_ = value; }

  [[nodiscard]] std::optional<double> computed(std::string_view name) const noexcept override;
  [[nodiscard]] std::optional<double> computed(int number) const noexcept override;

 private:
  using Failure = std::optional<Error>;

  struct Modes {
    const CodeInfo* motion = nullptr;  // null: G80
    Plane plane = Plane::kXy;
    bool inches = false;
    bool incremental = false;
    bool absolute_centres = false;
    bool inverse_time = false;
    bool retract_to_start = true;  // G98
    SetMotionControlMode control{};
    double naive_cam_mm = 0.0;
    double feed = 0.0;  // as programmed
    double speed_rpm = 0.0;
    int spindle = 0;                // 1 clockwise, -1 counterclockwise
    double surface_most_rpm = 0.0;  // G96; 0: G97
    bool mist = false;
    bool flood = false;
    std::array<bool, 4> overrides{true, true, false, true};  // by EnableOverride::Kind
    int selected_tool = 0;
    int tool = 0;
  };

  struct SavedState {
    bool valid = false;
    bool at_return = false;  // M73
    int system = 1;
    bool has_tool_offset = false;
    Modes modes{};
  };

  // What a line without these words takes from the line before, as long as the cycle goes on.
  struct CycleMemory {
    double start_height = 0.0;  // before the first of successive cycles
    double clearance = 0.0;     // these as programmed, in mm
    double bottom = 0.0;
    double peck = 0.0;
    double dwell_s = 0.0;
  };

  void emit(const CanonCall& call) noexcept { sink_.on_call(call, line_); }
  [[nodiscard]] double unit_mm() const noexcept { return modes_.inches ? kMmPerInch : 1.0; }
  [[nodiscard]] Failure whole(const Words& words, char letter, int least, int most, int& value) const noexcept;

  // executor_modes.cpp
  [[nodiscard]] Failure set_feed(const Block& block) noexcept;
  void set_units_and_plane(const Block& block) noexcept;
  [[nodiscard]] Failure set_control(const Block& block) noexcept;
  void emit_control() noexcept;
  void end_program(bool shuttle) noexcept;
  // executor_machine.cpp
  [[nodiscard]] Failure set_spindle_and_tool(const Block& block) noexcept;
  [[nodiscard]] Failure set_outputs(const Block& block) noexcept;
  [[nodiscard]] Failure wait_input(const Words& words, const CodeInfo& code) noexcept;
  void set_coolant(const Block& block) noexcept;
  [[nodiscard]] Failure set_overrides(const Block& block) noexcept;
  void switch_override(EnableOverride::Kind kind, bool on) noexcept;
  void turn_spindle(int direction) noexcept;
  void stop(const CodeInfo* code) noexcept;
  // executor_state.cpp
  [[nodiscard]] Failure use_saved_state(const Block& block) noexcept;
  void restore_state(const SavedState& saved) noexcept;
  void restore_coolant(bool mist, bool flood) noexcept;
  [[nodiscard]] bool has_tool_offset() const noexcept;
  // executor_offsets.cpp
  [[nodiscard]] Failure set_tool_offset(const Block& block) noexcept;
  void set_system(const Block& block) noexcept;
  void change_system(int system) noexcept;
  [[nodiscard]] Failure execute_once(const Block& block) noexcept;
  [[nodiscard]] Failure set_data(const Block& block) noexcept;
  [[nodiscard]] Failure set_tool_data(const Block& block, int kind) noexcept;
  [[nodiscard]] Failure set_system_data(const Block& block, int kind) noexcept;
  void set_g92(const Block& block, const CodeInfo& code) noexcept;
  void apply_offsets(const Offsets& offsets) noexcept;
  [[nodiscard]] Offsets with_system(int system) const noexcept;
  [[nodiscard]] Axes6 stored(int parameter) const noexcept;
  void store(int parameter, const Axes6& axes) noexcept;
  // executor_motion.cpp
  [[nodiscard]] Failure move(const Block& block) noexcept;
  [[nodiscard]] Failure feed_for(double length, double angle, const Words& words) noexcept;
  [[nodiscard]] Failure move_straight(const Block& block) noexcept;
  [[nodiscard]] Failure move_arc(const Block& block) noexcept;
  void go_home(const Block& block, int parameter) noexcept;
  // Replaces the words @ and ^ by X and Y. They count from the place before the line, in its modes.
  [[nodiscard]] Failure set_polar(Words& words, const Block& block) const noexcept;
  // The axis words of the line in place of some of the coordinates.
  [[nodiscard]] Axes6 with_words(const Words& words, Axes6 axes) const noexcept;
  // Where a motion ends, with absolute or incremental distances.
  [[nodiscard]] Axes6 target(const Words& words) const noexcept;
  void traverse(const Axes6& end) noexcept;
  // executor_cycle.cpp
  [[nodiscard]] Failure begin_cycle(const Block& block) noexcept;
  [[nodiscard]] Failure remember(const Block& block, bool goes_on) noexcept;

  CanonSink& sink_;
  Parameters parameters_;
  Modes modes_{};
  Offsets offsets_{};
  Axes6 place_{};                                        // in the active coordinate system
  std::array<std::optional<Axes6>, kMaxTools> tools_{};  // by number; 0: no tool
  DrillCycle cycle_{};
  CycleMemory memory_{};
  std::uint32_t line_ = 0;
  After after_ = After::kNext;
  std::optional<double> returned_{};
  std::size_t call_level_ = 0;                                 // calls that are under way
  std::array<SavedState, Parameters::kMaxCalls + 1> saved_{};  // by call level
};

}  // namespace armature::gcode
