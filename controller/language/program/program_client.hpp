// The client of core 1 that executes a program, whatever its language is.
//
// A program begins when the arm stands at the end of all moves before. It ends at once, and the arm stops, when the
// dispatcher refuses one of its commands, a stop cuts one short, or a fault comes. Nothing of it continues then before
// run().
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/arm_owner.hpp"
#include "controller/activity/tool_io.hpp"
#include "controller/command/core1_client.hpp"
#include "controller/language/program/breakpoints.hpp"
#include "controller/language/program/output_pulses.hpp"
#include "controller/language/program/program.hpp"
#include "controller/language/program/sent_commands.hpp"
#include "controller/message/event.hpp"
#include "controller/message/inbox.hpp"

namespace armature {

class ProgramClient final : public Core1Client, private ProgramPort {
 public:
  enum class State : std::uint8_t {
    kIdle,     // there is no program
    kReady,    // run() begins it
    kPending,  // its time has not come
    kRunning,  // or its last commands are under way
    kPaused,   // by the program, at a breakpoint, or after a single step
    kHeld,     // by hold()
    kEnded,
    kFailed,   // an alarm, a refused command, a stop or a fault
    kAborted,  // by abort()
  };
  enum class Mode : std::uint8_t {
    kOnce,
    kSingleSteps,  // pauses after each line, once the arm has executed it
    kAgain,        // from the beginning, again and again
  };

  // `events` gets all that the program reports (message/program_noted.hpp). References must outlive the client.
  ProgramClient(Inboxes& inboxes, const ArmOwner& owner, ToolIo& tool, EventListener& events) noexcept
      : inbox_{inbox_of(inboxes, Source::kProgram)},
        host_{inbox_of(inboxes, Source::kScenario)},
        orders_{inbox_of(inboxes, Source::kPendant)},
        owner_{owner},
        tool_{tool},
        events_{events} {}

  // A loaded program, without breakpoints. It starts at `start` after the start of the controller, and not before the
  // commands that the host has sent until then; none: with run(). Not while active().
  void set(Program& program, std::optional<Ticks> start) noexcept;
  // A pause of the program ends by itself after this time, as if the operator had said resume(). None: it does not.
  void resume_pauses_after(std::optional<Ticks> time) noexcept { resume_after_ = time; }
  // There is no program any more. Not while active().
  void clear() noexcept;

  // The operator's orders. False: not in this state, or the language does not have it.
  // Starts the program, at a line or at its beginning (0). Not while active().
  [[nodiscard]] bool run(Mode mode = Mode::kOnce, std::uint32_t line = 0) noexcept;
  // Brakes on the path. Only while kRunning.
  [[nodiscard]] bool hold() noexcept;
  // Continues after a hold or a pause.
  [[nodiscard]] bool resume() noexcept;
  // The same, until the next line was executed. After a hold the lines that were sent ahead come first.
  [[nodiscard]] bool step() noexcept;
  // Brakes and ends the program. Only while active().
  [[nodiscard]] bool abort() noexcept;
  // True when the program has this line, so that a breakpoint there can be reached.
  [[nodiscard]] bool has_line(ProgramPlace place) const noexcept {
    return program_ != nullptr && program_->has_line(place);
  }
  // May change at any time. A line that is under way, or was sent ahead of the arm, is not affected.
  [[nodiscard]] Breakpoints& breakpoints() noexcept { return breakpoints_; }

  [[nodiscard]] State state() const noexcept { return state_; }
  // The program has begun and is not over. The arm may belong to it.
  [[nodiscard]] bool active() const noexcept { return state_ >= State::kRunning && state_ <= State::kHeld; }
  // The last kMessage, kAlarm or kStopped since the program began, and how many there were since the start of the
  // controller. kLine: none.
  [[nodiscard]] const ProgramNote& last_note() const noexcept { return note_; }
  [[nodiscard]] std::uint32_t notes() const noexcept { return notes_; }
  // The line that began last. At a breakpoint it is the next one.
  [[nodiscard]] ProgramPlace line() const noexcept { return line_; }
  // Where the arm is: the line of its present command. Without one it is line().
  [[nodiscard]] ProgramPlace place() const noexcept { return sent_.over() ? line_ : sent_.place(); }

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus& bus) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override;
  void on_event(const Event& event) noexcept override;

 private:
  // ProgramPort, during execute().
  [[nodiscard]] bool has_room() const noexcept override { return !inbox_.full(); }
  void send(const Command& command, ProgramPlace place) noexcept override;
  [[nodiscard]] bool stop() noexcept override;
  [[nodiscard]] bool done() const noexcept override;
  [[nodiscard]] JointAngles joints() const noexcept override;
  [[nodiscard]] bool level(std::uint8_t pin, bool output) noexcept override;
  void pulse(std::uint8_t pin, Ticks duration) noexcept override;
  [[nodiscard]] Ticks now() noexcept override;
  void note(const ProgramNote& note) noexcept override;
  [[nodiscard]] bool breakpoint_at(ProgramPlace place) noexcept override;
  void charge_inverses(std::int64_t count) noexcept override { bus_->charge(Work::kInverse, count); }

  void report(ProgramNote::Kind kind, ProgramPlace at) noexcept { note({.kind = kind, .place = at}); }
  void start() noexcept;
  void forget_lines() noexcept;
  [[nodiscard]] bool continue_lines(bool single_step) noexcept;
  [[nodiscard]] bool stop_before(State state) noexcept;
  [[nodiscard]] bool enter_next_state() noexcept;
  [[nodiscard]] bool step_program() noexcept;
  void on_fault(FaultCause cause) noexcept;

  Inbox& inbox_;
  const Inbox& host_;  // what the dispatcher has not yet accepted from there is a move before the program
  Inbox& orders_;      // another inbox, because orders overtake the commands of the program
  const ArmOwner& owner_;
  ToolIo& tool_;
  EventListener& events_;
  Program* program_ = nullptr;
  RegisterBus* bus_ = nullptr;  // during execute()
  Ticks start_at_{};
  std::optional<Ticks> resume_after_;
  Ticks resume_at_{};  // kPaused with resume_after_
  Mode mode_ = Mode::kOnce;
  State state_ = State::kIdle;
  bool started_ = false;             // kRunning: the program has been started
  bool stopping_ = false;            // the arm was told to stop, or a fault has stopped it
  std::optional<State> next_state_;  // kRunning: the lines are over, this follows when the commands are
  SentCommands sent_;
  Breakpoints breakpoints_;
  std::optional<ProgramPlace> breakpoint_;  // the one that the program has come to
  OutputPulses pulses_;
  std::uint16_t inputs_read_ = 0;  // in this step, bit 0 for pin 1
  ProgramNote note_{};
  std::uint32_t notes_ = 0;
  ProgramPlace line_ = 0;
};

}  // namespace armature
