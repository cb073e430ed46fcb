// What the pendant does with programs: it sends them, runs and holds them, and sets their breakpoints.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/cell/robot_cell.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/language/gcode/run/motion_setup.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "controller/language/program/program_client.hpp"
#include "controller/pendant/parts/coordinates.hpp"
#include "controller/pendant/parts/pendant_line.hpp"
#include "controller/pendant/parts/program_store.hpp"
#include "controller/pendant/protocol/answer.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

class Programs {
 public:
  // What the arguments refer to must outlive the object.
  Programs(const RobotCell& cell, const job::MachineSettings& jobs, const gcode::MotionSettings& gcode,
           ProgramClient& client) noexcept
      : client_{client}, store_{cell, jobs, gcode} {}

  [[nodiscard]] const ProgramClient& client() const noexcept { return client_; }

  // The transfer of a text.
  [[nodiscard]] Answer begin(Content content, std::int32_t size) noexcept;
  [[nodiscard]] std::optional<Frame> push(const BulkFrame& frame) noexcept { return store_.push(frame); }
  void cancel() noexcept { store_.cancel(); }
  // Loads what has come. The line is polled meanwhile.
  [[nodiscard]] Answer commit(std::int32_t check, PendantLine& line, RegisterBus& bus) noexcept;
  [[nodiscard]] Answer select(std::size_t job) noexcept { return store_.select(job); }

  // kOk, or why there is nothing to run in the coordinates that the operator has selected.
  [[nodiscard]] Status may_run(const Coordinates& selected) const noexcept;
  // `user`: the selected user frame.
  [[nodiscard]] Answer run(RunMode mode, std::uint32_t line, std::optional<FrameId> user) noexcept;
  [[nodiscard]] Answer hold() noexcept { return accepted(client_.hold()); }
  [[nodiscard]] Answer resume() noexcept { return accepted(client_.resume()); }
  [[nodiscard]] Answer step() noexcept { return accepted(client_.step()); }
  [[nodiscard]] Answer abort() noexcept { return accepted(client_.abort()); }
  [[nodiscard]] Answer set_breakpoint(BreakpointAction action, ProgramPlace line) noexcept;
  // A program that the pendant has run is running.
  [[nodiscard]] bool runs() const noexcept {
    return started_here_ && client_.state() == ProgramClient::State::kRunning;
  }

 private:
  [[nodiscard]] static constexpr Answer accepted(bool order) noexcept {
    return {.status = order ? Status::kOk : Status::kBusy};
  }
  void use_store(bool loaded) noexcept;

  ProgramClient& client_;
  ProgramStore store_;
  bool started_here_ = false;  // the pendant has run the program
  bool from_store_ = false;    // the program is that of the store
};

}  // namespace armature::pendant
