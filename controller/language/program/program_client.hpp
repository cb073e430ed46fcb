// The client of core 1 that executes a program, whatever its language is.
//
// It begins when its time has come and the arm stands at the end of all moves before. If the dispatcher refuses a
// command of the program, the program ends there and the arm stops.
#pragma once

#include <cstdint>

#include "controller/command/core1_client.hpp"
#include "controller/command/dispatcher.hpp"
#include "controller/command/inbox.hpp"
#include "controller/command/tool_io.hpp"
#include "controller/language/program/interpreter.hpp"

namespace armature {

class ProgramClient final : public Core1Client, private ProgramPort {
 public:
  enum class State : std::uint8_t {
    kIdle,     // there is no program
    kPending,  // its time has not come
    kRunning,
    kPaused,  // resume() continues
    kEnded,
    kFailed,  // an alarm, or a refused command
  };

  // References must outlive the client.
  ProgramClient(Inboxes& inboxes, const Dispatcher& dispatcher, ToolIo& tool) noexcept
      : inbox_{inbox_of(inboxes, Source::kProgram)}, dispatcher_{dispatcher}, tool_{tool} {}

  // A loaded program, which begins at `begin` after the start of the controller.
  void set(Interpreter& program, Ticks begin) noexcept;
  void resume() noexcept;

  [[nodiscard]] State state() const noexcept { return state_; }
  // The last message or alarm, and the line that began last.
  [[nodiscard]] const ProgramNote& last_note() const noexcept { return note_; }
  [[nodiscard]] ProgramPlace line() const noexcept { return line_; }

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus& bus) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override;
  void on_event(const Event& event) noexcept override;

 private:
  // ProgramPort, during execute().
  [[nodiscard]] bool has_room() const noexcept override { return !inbox_.full(); }
  void send(const Command& command, ProgramPlace place) noexcept override;
  [[nodiscard]] bool done() const noexcept override;
  [[nodiscard]] JointAngles joints() const noexcept override;
  [[nodiscard]] bool level(std::uint8_t pin, bool output) noexcept override;
  void set_now(std::uint8_t pin, bool level) noexcept override;
  [[nodiscard]] Ticks now() noexcept override;
  void note(const ProgramNote& note) noexcept override;

  void settle(Tag tag) noexcept;

  Inbox& inbox_;
  const Dispatcher& dispatcher_;
  ToolIo& tool_;
  Interpreter* program_ = nullptr;
  RegisterBus* bus_ = nullptr;  // during execute()
  Ticks begin_{};
  State state_ = State::kIdle;
  std::uint32_t under_way_ = 0;  // commands that were sent and are not over
  bool refused_ = false;
  ProgramNote note_{};
  ProgramPlace line_ = 0;
};

}  // namespace armature
