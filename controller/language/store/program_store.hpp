// The program of the controller: its encoded jobs, and what executes it.
//
// It comes with the start of the controller, or is sent later. Jobs are encoded when they are loaded. A G-code program
// is executed as text, which must stay in memory. All memory is in this object; what does not fit is an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/cell/frames.hpp"
#include "controller/cell/robot_cell.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/language/gcode/run/program_runner.hpp"
#include "controller/language/job/execute/machine.hpp"
#include "controller/language/job/loader/loader.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/language/program/program.hpp"
#include "controller/language/store/program_files.hpp"
#include "controller/language/text/diagnostics.hpp"

namespace armature {

class ProgramStore {
 public:
  enum class Loaded : std::uint8_t { kYes, kFull, kError };

  // What the cell refers to must outlive the store.
  ProgramStore(const RobotCell& cell, const job::MachineSettings& jobs, const gcode::MotionSettings& gcode) noexcept
      : machine_setup_{.cell = cell, .settings = jobs},
        machine_{std::in_place, memory_, machine_setup_},
        frame_{gcode.frame},
        gcode_setup_{.cell = cell, .settings = gcode},
        gcode_{std::in_place, gcode_setup_} {}
  ProgramStore(const ProgramStore&) = delete;
  ProgramStore& operator=(const ProgramStore&) = delete;

  // The program of the start, before any other. `files` has at least one; all must stay in memory.
  [[nodiscard]] Loaded load_first(const ProgramFiles& files, std::string_view names, std::string_view texts) noexcept;

  // A program that is sent takes the place of the one before. Nothing that a program of the start has set stays: its
  // parameters, variables and tools. What a sent program sets stays for the next one.
  void load_sent_gcode(std::string_view text) noexcept;
  // The program begins with this job. `further`: the jobs that were sent before stay. After an error there is no
  // program.
  [[nodiscard]] Loaded load_sent_job(std::string_view text, bool further) noexcept;
  // The text of a sent G-code program is about to be overwritten. False: there is no such program.
  [[nodiscard]] bool drop_sent_gcode() noexcept;

  // The job that a sent program begins with. False: there is no such job.
  [[nodiscard]] bool select(std::size_t job) noexcept;
  // The job that was sent last.
  [[nodiscard]] std::size_t last_job() const noexcept { return memory_.job_count - 1; }
  [[nodiscard]] bool has_sent_gcode() const noexcept { return !of_start_ && program_ == &*gcode_; }
  // The frame of sent G-code programs, from their next begin on; none: that of the settings.
  void set_sent_gcode_frame(std::optional<FrameId> frame) noexcept;

  // The loaded program; null: there is none.
  [[nodiscard]] Program* program() noexcept { return program_; }

  // The first error of the last program that did not load, as FILE:LINE:COLUMN: TEXT, and its line. The file of a sent
  // program has no name.
  [[nodiscard]] std::string_view error() const noexcept { return error_.text.view(); }
  [[nodiscard]] std::uint32_t error_line() const noexcept { return error_.line; }

 private:
  class FirstError final : public Diagnostics {
   public:
    void report(const Diagnostic& diagnostic) noexcept override;
    void clear() noexcept { text.clear(), line = 0; }
    DiagnosticText text{};
    std::uint32_t line = 0;
  };

  [[nodiscard]] Loaded link() noexcept;
  void forget_first() noexcept;

  job::ProgramMemory memory_{};
  FirstError error_{};
  job::Loader loader_{memory_, error_};
  job::MachineSetup machine_setup_;
  std::optional<job::Machine> machine_;
  FrameId frame_;
  gcode::MotionSetup gcode_setup_;
  std::optional<gcode::ProgramRunner> gcode_;
  Program* program_ = nullptr;
  bool of_start_ = false;  // the jobs in memory, or the G-code program, are those of the start
};

}  // namespace armature
