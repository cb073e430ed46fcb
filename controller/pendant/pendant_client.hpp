// The client of core 1 that a teach pendant controls the arm through. PROTOCOL.md has the commands.
//
// It keeps the state of the arm from the events of both cores, admits commands by it, executes them through an inbox of
// the dispatcher, and replies. Moves, the drives and outputs are answered when the events say what has become of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/tag.hpp"
#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/cell/planning_config.hpp"
#include "controller/command/core1_client.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/language/program/program_client.hpp"
#include "controller/message/event.hpp"
#include "controller/message/inbox.hpp"
#include "controller/motion/arm_position.hpp"
#include "controller/pendant/admission.hpp"
#include "controller/pendant/answer.hpp"
#include "controller/pendant/arm_state.hpp"
#include "controller/pendant/command_link.hpp"
#include "controller/pendant/coordinates.hpp"
#include "controller/pendant/frame.hpp"
#include "controller/pendant/pendant_config.hpp"
#include "controller/pendant/pendant_line.hpp"
#include "controller/pendant/pressed_axes.hpp"
#include "controller/pendant/program_store.hpp"
#include "controller/pendant/staged_move.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::pendant {

inline constexpr Cycles kMillisecond{kClkFreqHz / 1'000};

class PendantClient final : public Core1Client {
 public:
  // References must outlive the client.
  PendantClient(const PendantConfig& config, const RobotModel& robot, const Arm& arm, const PlanningConfig& planning,
                const ArmPosition& position, Inbox& inbox, ProgramClient& program) noexcept;
  PendantClient(const PendantClient&) = delete;
  PendantClient& operator=(const PendantClient&) = delete;

  [[nodiscard]] InterruptHandler& line() noexcept { return line_; }

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus& bus) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override;
  void on_event(const Event& event) noexcept override;

 private:
  [[nodiscard]] State state() const noexcept;
  [[nodiscard]] bool moves() const noexcept;
  void switch_on_when_due() noexcept;
  void on_frame(const FrameBytes& bytes, RegisterBus& bus) noexcept;
  // None: on_event() will answer.
  [[nodiscard]] std::optional<Answer> execute_command(const Frame& command, RegisterBus& bus) noexcept;
  [[nodiscard]] std::optional<Answer> switch_drives(bool on) noexcept;
  [[nodiscard]] std::optional<Answer> move(const Frame& command) noexcept;
  [[nodiscard]] std::optional<Answer> home(std::uint8_t axes) noexcept;
  [[nodiscard]] Answer stage(const Frame& command) noexcept;
  // Programs, in a file of their own.
  [[nodiscard]] Answer program_command(const Frame& command, RegisterBus& bus) noexcept;
  [[nodiscard]] Answer load_program(std::int32_t check, RegisterBus& bus) noexcept;
  void use_stored_program(bool loaded) noexcept;
  [[nodiscard]] Answer run(ProgramClient::Mode mode, std::uint32_t line) noexcept;
  [[nodiscard]] Answer set_breakpoint(BreakpointAction action, ProgramPlace line) noexcept;
  [[nodiscard]] bool watches_program() const noexcept;
  void jog() noexcept;
  [[nodiscard]] Answer stop(Stop::Kind kind) noexcept;
  [[nodiscard]] std::optional<Answer> give(Command command) noexcept;
  void on_estop() noexcept;
  void watch_the_line() noexcept;
  void send_telemetry() noexcept;
  [[nodiscard]] std::int32_t page(std::uint8_t number) const noexcept;
  [[nodiscard]] std::int32_t message_page(std::uint8_t number) const noexcept;
  void reply(const Answer& answer) noexcept;

  // The events that matter.
  void on(const MoveStarted& started) noexcept;
  void on(const MoveFinished&) noexcept;
  void on(const MoveRefused& refused) noexcept;
  void on(const IoDone& done) noexcept;
  void on(const Faulted& faulted) noexcept;
  void on(const FaultCleared&) noexcept;
  void on(const JogStarted&) noexcept { jogs_ = true; }
  void on(const JogEnded&) noexcept { jogs_ = false; }
  void on(const HomingStarted& axis) noexcept;
  void on(const HomingEnded& axis) noexcept;
  template <class Other>
  void on(const Other&) noexcept {}

  PendantConfig config_;
  const ArmPosition& position_;
  Inbox& inbox_;
  ProgramClient& program_;
  PendantLine line_;
  CommandLink link_;
  Coordinates coordinates_;
  StagedMove staged_;
  PressedAxes pressed_;
  ProgramStore store_;
  double jog_limit_ = 0.25;        // share of the largest speeds
  ArmFacts arm_facts_{};           // without `jog` and `move`
  bool jogs_ = false;              // a jog has begun
  std::int32_t moves_ = 0;         // under way
  std::uint8_t homing_ = 0;        // axes that are being homed, and those that wait for it; bit 0 for axis 1
  std::uint8_t homing_asked_ = 0;  // by the pendant
  std::int32_t alarm_ = 0;         // as in Page::kAlarm
  std::uint32_t commands_ = 0;     // given to the dispatcher
  std::optional<Opcode> waits_{};  // the command whose answer depends on an event
  Tag waits_for_{};
  std::optional<Answer> answer_{};  // of that event
  bool gave_ = false;               // a command, in this execute()
  bool mine_ = false;               // the present motion was commanded by the pendant
  bool runs_ = false;               // the pendant has run the program
  bool stored_program_ = false;     // the program is that of the store
  Cycles now_{};                    // of this execute()
  Cycles settling_{};               // of a fault that has just begun
  Cycles drives_on_at_{};           // earliest: the arm must have stood for some time
  bool drives_wanted_ = false;      // until that time
  Cycles heard_{};                  // when the last valid frame came
  std::uint8_t pages_ = 0;          // groups of the telemetry
  Cycles period_{};                 // of the telemetry; 0: none
  Cycles telemetry_at_{};
  std::uint8_t telemetry_sequence_ = 0;
};

}  // namespace armature::pendant
