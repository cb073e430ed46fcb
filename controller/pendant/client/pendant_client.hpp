// The client of core 1 that a teach pendant controls the arm through. PROTOCOL.md has the commands.
//
// It admits a command by the state of the arm, executes it (command_table.hpp), and replies. Moves, the drives and
// outputs are answered when the events say what has become of them. It also stops the arm when the line is silent.
#pragma once

#include <optional>

#include "controller/base/units.hpp"
#include "controller/command/core1_client.hpp"
#include "controller/hal/interrupt_handler.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/event.hpp"
#include "controller/pendant/client/pendant_parts.hpp"
#include "controller/pendant/protocol/answer.hpp"
#include "controller/pendant/protocol/command_link.hpp"
#include "controller/pendant/protocol/frame.hpp"

namespace armature::pendant {

class PendantClient final : public Core1Client {
 public:
  // References must outlive the client.
  PendantClient(const PendantConfig& config, const RobotModel& robot, const Arm& arm, const PlanningConfig& planning,
                const ArmPosition& position, const ArmOwner& owner, Inbox& inbox, ProgramStore& store,
                ProgramClient& program) noexcept
      : parts_{config, robot, arm, planning, position, owner, inbox, store, program} {}

  [[nodiscard]] InterruptHandler& line() noexcept { return parts_.line; }

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus& bus) noexcept override;
  [[nodiscard]] bool waits_for_time() const noexcept override;
  void on_event(const Event& event) noexcept override;

 private:
  void on_estop() noexcept;
  void on_frame(const FrameBytes& bytes, RegisterBus& bus) noexcept;
  void switch_on_when_due() noexcept;
  void watch_the_line() noexcept;
  [[nodiscard]] bool watches_program() const noexcept;
  void send(const Frame& frame) noexcept { parts_.line.send(encode(frame)); }
  void reply(const Answer& answer) noexcept;

  PendantParts parts_;
  CommandLink link_;
  Cycles now_{};            // of this execute()
  Cycles last_frame_at_{};  // a valid one
};

}  // namespace armature::pendant
