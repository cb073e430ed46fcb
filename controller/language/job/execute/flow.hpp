// Where a program is, and how it comes from one instruction to another: jumps, blocks, loops and calls.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/state/operand_reader.hpp"
#include "controller/language/job/state/step.hpp"
#include "controller/language/job/state/variables.hpp"

namespace armature::job {

class Flow {
 public:
  // References must outlive it. Each call has its local variables in `variables`.
  Flow(const ProgramMemory& memory, Variables& variables) noexcept : memory_{memory}, variables_{variables} {}

  // At the first instruction of a job at or behind a line; not behind its last one. kLocals: there is no room.
  [[nodiscard]] Alarm start(std::size_t job, std::uint32_t line) noexcept;
  // The record here is executed: to the one that it has selected, by default the next one.
  void advance() noexcept { stand_at(next_); }

  [[nodiscard]] std::size_t job() const noexcept { return current_.job; }
  [[nodiscard]] std::uint16_t at() const noexcept { return current_.record; }
  [[nodiscard]] std::span<const Record> records() const noexcept {
    return memory_.records_of(memory_.jobs[current_.job]);
  }

  // Instructions. False: the step says why the record here is not executed.
  [[nodiscard]] bool jump(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool call(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool get_argument(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool return_value(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool return_from_job(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool branch(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool select_case(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool start_while(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool start_loop(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool repeat_loop(Step& step, OperandReader& operands) noexcept;
  // To the other end of a block: ELSE and CASE end the branch before them, ENDWHILE goes back.
  [[nodiscard]] bool go_to_partner(Step& step, OperandReader& operands) noexcept;

 private:
  static constexpr std::size_t kMaxArguments = 8;
  struct Point {
    std::size_t job = 0;
    std::uint16_t record = 0;
  };
  struct Argument {
    bool is_position = false;
    double number = 0.0;
    PositionValue position{};
  };
  struct Call {
    Point return_to{};
    std::size_t argument_count = 0;
    std::array<Argument, kMaxArguments> arguments{};
  };

  void stand_at(Point point) noexcept {
    current_ = point;
    go_to(point.record + 1U);
  }
  // Within the job.
  void go_to(std::size_t record) noexcept { next_ = {current_.job, static_cast<std::uint16_t>(record)}; }
  [[nodiscard]] bool jump_to_label(Step& step, OperandReader& operands) noexcept;
  [[nodiscard]] bool read_arguments(Step& step, OperandReader& operands, Call& call) noexcept;
  // FOR, whose record is `at`: sets the variable, or adds the step to it.
  [[nodiscard]] bool loop(Step& step, OperandReader& operands, std::uint16_t at, bool first) noexcept;

  const ProgramMemory& memory_;
  Variables& variables_;
  Point current_{}, next_{};
  std::array<Call, Variables::kMaxCalls + 1> calls_{};
  std::size_t depth_ = 0;  // of calls_; 1: the first job
};

}  // namespace armature::job
