// Executes the blocks of a program in the order that the language defines. Its parts make the canonical calls.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/gcode/canon/canon.hpp"
#include "controller/language/gcode/canon/line_calls.hpp"
#include "controller/language/gcode/execute/coolant.hpp"
#include "controller/language/gcode/execute/coordinates.hpp"
#include "controller/language/gcode/execute/cycles.hpp"
#include "controller/language/gcode/execute/modes.hpp"
#include "controller/language/gcode/execute/motion.hpp"
#include "controller/language/gcode/execute/overrides.hpp"
#include "controller/language/gcode/execute/saved_states.hpp"
#include "controller/language/gcode/execute/spindle.hpp"
#include "controller/language/gcode/execute/tools.hpp"
#include "controller/language/gcode/reader/block.hpp"
#include "controller/language/gcode/reader/parameters.hpp"

namespace armature::gcode {

class Executor final : public ComputedParameters {
 public:
  // What the program does next.
  enum class After : std::uint8_t { kNext, kStop, kWaitInput, kEnd };

  explicit Executor(CanonSink& sink) noexcept : calls_(sink) {}
  // The parts refer to each other.
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  // Forgets modes, names and places: `machine` is where the tool is, in coordinates of the machine. Offsets of
  // coordinate systems and tools stay. Makes the calls of the start.
  void begin_program(const Axes6& machine) noexcept;

  // What stays from program to program: parameters from 5001 on, and tools.
  struct Stored {
    std::array<double, Parameters::kLast + 1 - kFirstStored> parameters{};
    Tools::Table tools{};
  };
  void save(Stored& stored) const noexcept;
  void restore(const Stored& stored) noexcept;

  // The line whose values are read, and which then makes the calls: #<_line>.
  void begin_line(std::uint32_t line) noexcept { calls_.begin_line(line); }
  void say(Text::Kind kind, std::string_view text) noexcept { calls_.emit(Text{.kind = kind, .text = text}); }
  // An error has neither a line nor, mostly, a column.
  [[nodiscard]] Failure execute(Block& block) noexcept;
  // The rest of a drilling cycle. A block that begins one continues here; each call makes a few canonical calls.
  [[nodiscard]] bool in_cycle() const noexcept { return cycles_.active(); }
  void continue_cycle() noexcept { cycles_.step(); }
  [[nodiscard]] After after() const noexcept { return after_; }
  // The value of an input that WaitInput asked for.
  void give_input(double value) noexcept { parameters_.at(kInputParameter) = value; }
  // A subroutine or a subprogram begins and ends.
  void begin_call() noexcept { saved_states_.begin_call(); }
  void end_call() noexcept { saved_states_.end_call(); }
  void set_returned(std::optional<double> value) noexcept { returned_ = value; }
  // The end of the program, as with M2, or with M30 and a shuttle.
  void end_program(bool shuttle) noexcept;

  [[nodiscard]] Parameters& parameters() noexcept { return parameters_; }
  [[nodiscard]] Tools& tools() noexcept { return tools_; }

  [[nodiscard]] std::optional<double> computed(std::string_view name) const noexcept override;
  [[nodiscard]] std::optional<double> computed(int number) const noexcept override;

 private:
  [[nodiscard]] Failure dwell(const Block& block) noexcept;
  [[nodiscard]] Failure execute_once(const Block& block) noexcept;
  void stop(const Block& block) noexcept;

  LineCalls calls_;
  Parameters parameters_{*this};
  Modes modes_{calls_};
  Spindle spindle_{calls_};
  Coolant coolant_{calls_};
  Overrides overrides_{calls_};
  Tools tools_{calls_, spindle_};
  Coordinates coordinates_{calls_, modes_, tools_, parameters_};
  SavedStates saved_states_{modes_, spindle_, coolant_, overrides_, coordinates_};
  Cycles cycles_{calls_, modes_, spindle_, overrides_, coordinates_};
  Motion motion_{calls_, modes_, coordinates_, cycles_};
  After after_ = After::kNext;
  std::optional<double> returned_{};
};

}  // namespace armature::gcode
