// What the pendant does with programs: it sends them, runs and holds them, and sets their breakpoints.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/cell/frames.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/language/program/program_client.hpp"
#include "controller/language/store/program_store.hpp"
#include "controller/pendant/parts/coordinates.hpp"
#include "controller/pendant/parts/pendant_line.hpp"
#include "controller/pendant/protocol/answer.hpp"
#include "controller/pendant/protocol/bulk_receiver.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

class Programs {
 public:
  static constexpr std::size_t kMaxCharacters = std::size_t{256} * 1024;

  // References must outlive the object.
  Programs(ProgramStore& store, ProgramClient& client) noexcept : store_{store}, client_{client} {}
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  [[nodiscard]] const ProgramClient& client() const noexcept { return client_; }

  // The transfer of a text.
  [[nodiscard]] Answer begin(Content content, std::int32_t size) noexcept;
  [[nodiscard]] std::optional<Frame> push(const BulkFrame& frame) noexcept { return receiver_.push(frame); }
  void cancel() noexcept { receiver_.cancel(); }
  // Loads what has come; after an error there is no program. The line is polled meanwhile.
  [[nodiscard]] Answer commit(std::int32_t check, PendantLine& line, RegisterBus& bus) noexcept;
  // The job that the program begins with.
  [[nodiscard]] Answer select(std::size_t job) noexcept;

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
  [[nodiscard]] Answer load_job(std::string_view text) noexcept;

  ProgramStore& store_;
  ProgramClient& client_;
  std::array<char, kMaxCharacters> characters_{};
  BulkReceiver receiver_{characters_};
  Content content_ = Content::kJob;
  bool started_here_ = false;  // the pendant has run the program
};

}  // namespace armature::pendant
