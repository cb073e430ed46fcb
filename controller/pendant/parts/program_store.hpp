// The program that the pendant has sent: its characters, its encoded jobs, and what executes it.
//
// Jobs are encoded when their transfer ends. A G-code program stays as text, so the next transfer replaces it. All
// memory is in this object, about 1.1 MB; what does not fit is a status.
#pragma once

#include <array>
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
#include "controller/language/text/diagnostics.hpp"
#include "controller/pendant/protocol/answer.hpp"
#include "controller/pendant/protocol/bulk_receiver.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

class ProgramStore {
 public:
  static constexpr std::size_t kMaxCharacters = std::size_t{256} * 1024;

  // What the cell refers to must outlive the store.
  ProgramStore(const RobotCell& cell, const job::MachineSettings& jobs, const gcode::MotionSettings& gcode) noexcept
      : machine_{memory_, {.cell = cell, .settings = jobs}},
        frame_{gcode.frame},
        gcode_setup_{.cell = cell, .settings = gcode} {}
  ProgramStore(const ProgramStore&) = delete;
  ProgramStore& operator=(const ProgramStore&) = delete;

  [[nodiscard]] Answer begin(Content content, std::int32_t size) noexcept;
  // The acknowledgement to send, if it is time for one.
  [[nodiscard]] std::optional<Frame> push(const BulkFrame& frame) noexcept { return receiver_.push(frame); }
  // Loads what was received. After an error there is no program.
  [[nodiscard]] Answer commit(std::int32_t check) noexcept;
  void cancel() noexcept { receiver_.cancel(); }
  // The job that the program begins with.
  [[nodiscard]] Answer select(std::size_t job) noexcept;

  // The loaded program; nullptr: there is none.
  [[nodiscard]] Program* program() noexcept { return program_; }
  [[nodiscard]] bool has_gcode() const noexcept { return program_ == &gcode_; }
  // Number of lines that the last commit() has read.
  [[nodiscard]] std::int64_t lines_read() const noexcept { return lines_read_; }
  // The frame of a G-code program, from its next begin on; none: that of the setup.
  void set_gcode_frame(std::optional<FrameId> frame) noexcept { gcode_setup_.settings.frame = frame.value_or(frame_); }

 private:
  class FirstError final : public Diagnostics {
   public:
    void report(const Diagnostic& diagnostic) noexcept override {
      if (diagnostic.severity == Diagnostic::Severity::kError && line == 0) line = diagnostic.line;
    }
    std::uint32_t line = 0;
  };

  [[nodiscard]] Answer load_job(std::string_view text) noexcept;

  std::array<char, kMaxCharacters> characters_{};
  BulkReceiver receiver_{characters_};
  Content content_ = Content::kJob;
  std::int64_t lines_read_ = 0;
  job::ProgramMemory memory_{};
  FirstError error_{};
  job::Loader loader_{memory_, error_};
  job::Machine machine_;
  FrameId frame_;
  gcode::MotionSetup gcode_setup_;
  gcode::ProgramRunner gcode_{gcode_setup_};
  Program* program_ = nullptr;
};

}  // namespace armature::pendant
