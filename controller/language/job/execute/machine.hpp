// Executes encoded jobs: the virtual machine of the robot language.
//
// A step executes one record. Moves, dwells and outputs are sent ahead of the arm through the port. What depends on the
// state of the cell waits until all of that is over: inputs and outputs that are read, PULSE, GETS of the present
// position, PAUSE, and an alarm. So does a target that the joints at the end of a path decide: IMOV by joints, a
// posture at a singularity, and a joint move to a posture that several whole turns reach. Arithmetic, jumps and MSG are
// executed ahead, too.
#pragma once

#include <cstddef>
#include <cstdint>

#include "controller/language/job/execute/parts.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/state/alarm.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/language/job/state/variables.hpp"
#include "controller/language/program/program.hpp"

namespace armature::job {

class Machine final : public Program {
 public:
  // References must outlive the machine. All jobs of the memory must be loaded and linked.
  Machine(const ProgramMemory& memory, const MachineSetup& setup) noexcept : parts_{memory, setup} {}

  // Where start() starts: in a job, at its first instruction at or behind a line.
  void select(std::size_t job, std::uint32_t line = 0) noexcept;

  // Program
  void start() noexcept override;
  [[nodiscard]] Progress step(ProgramPort& port) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override { return timed_wait_; }
  // Of the job that select() has named. False also for a line behind its last instruction.
  [[nodiscard]] bool select_line(std::uint32_t line) noexcept override;
  [[nodiscard]] bool has_line(ProgramPlace place) const noexcept override;
  void set_single_step(bool on) noexcept override { single_step_ = on; }

  [[nodiscard]] Alarm alarm() const noexcept { return alarm_; }
  [[nodiscard]] Variables& variables() noexcept { return parts_.variables; }
  // The job and the line of the next instruction.
  [[nodiscard]] std::size_t job() const noexcept { return parts_.flow.job(); }
  [[nodiscard]] std::uint32_t line() const noexcept { return parts_.flow.records()[parts_.flow.at()].line; }

  // A place is a job in the upper 8 bits and a line in the lower 16.
  [[nodiscard]] static constexpr ProgramPlace place_of(std::size_t job, std::uint32_t line) noexcept {
    return static_cast<ProgramPlace>(job << 16U | line);
  }
  [[nodiscard]] static constexpr std::size_t job_of(ProgramPlace place) noexcept { return place >> 16U; }
  [[nodiscard]] static constexpr std::uint32_t line_of(ProgramPlace place) noexcept { return place & 0xFFFFU; }

 private:
  // Of the record that is next.
  [[nodiscard]] Step step_here(ProgramPort& port) const noexcept;
  void finish_record(const Step& step) noexcept;

  Parts parts_;
  std::size_t first_job_ = 0;
  std::uint32_t first_line_ = 0;
  Alarm alarm_ = Alarm::kNone;
  bool line_noted_ = false;  // that of the record here
  bool pause_when_done_ = false;
  bool paused_here_ = false;  // before the record here: a breakpoint does not pause once more
  bool single_step_ = false;
  bool timed_wait_ = false;
};

}  // namespace armature::job
