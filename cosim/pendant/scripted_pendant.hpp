// The operator of a scenario and his pendant: executes the steps on the serial line, and judges them.
//
// Between the steps the pendant keeps the link alive. A line that loses bytes delays a step; a step fails when its time
// is over, or when a command stays without a reply after its repetitions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "controller/pendant/protocol/frame.hpp"
#include "controller/pendant/protocol/frame_receiver.hpp"
#include "cosim/pendant/bulk_sender.hpp"
#include "cosim/pendant/command_sender.hpp"
#include "cosim/pendant/message_reader.hpp"
#include "cosim/pendant/pendant_spec.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/serial/serial_peer.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {

class ScriptedPendant final : public SerialPeer {
 public:
  using Time = CommandSender::Time;
  // What happened in a step, for the log.
  using Listener = std::function<void(const std::string&)>;

  // References must outlive the pendant.
  ScriptedPendant(const PendantSpec& spec, const RobotSpec& robot, std::uint64_t seed, Listener listener);

  // SerialPeer
  void exchange(Cycles now, std::size_t room, std::vector<std::uint8_t>& in) override;
  void send(std::uint8_t byte) override;

  // Why a step failed, with its number and the line of its table.
  [[nodiscard]] const std::optional<std::string>& failure() const { return failure_; }
  // The same for a step that is not complete at the end of the run.
  [[nodiscard]] std::optional<std::string> unfinished() const;

 private:
  [[nodiscard]] const PendantStepSpec* step() const {
    return next_step_ < spec_.steps.size() ? &spec_.steps[next_step_] : nullptr;
  }
  [[nodiscard]] std::string name_of_step() const;
  void on_frame(const pendant::Frame& frame);
  void on_reply(const pendant::Frame& reply);
  void act();
  void begin_step(const PendantStepSpec& step);
  void continue_step(const PendantStepSpec& step);
  void continue_jog(const PendantStepSpec& step);
  void continue_download();
  void send_next();
  void read_message();
  void on_page(const PendantStepSpec& step, const pendant::Frame& reply);
  [[nodiscard]] std::string too_late(const PendantStepSpec& step, double within_ms) const;
  void press_estop();
  void complete_step(const std::string& how);
  void fail(const std::string& why);
  void command(const pendant::Frame& frame);
  void put(const pendant::FrameBytes& bytes);
  // The byte after the faults of the line; nothing when it is lost.
  [[nodiscard]] std::optional<std::uint8_t> through_the_line(std::uint8_t byte);

  const PendantSpec& spec_;
  const RobotSpec& robot_;
  Random random_;
  Listener listener_;
  pendant::FrameReceiver receiver_{pendant::End::kPendant};
  CommandSender sender_;
  std::deque<std::uint8_t> out_;
  int silent_polls_ = 0;
  Time now_{};

  bool in_session_ = false;
  std::int32_t session_ = 0;
  Time last_command_{};
  std::size_t next_step_ = 0;
  bool begun_ = false;  // the step next_step_
  Time began_{};
  std::deque<pendant::Frame> to_send_;  // of that step
  std::optional<BulkSender> text_;      // of a program that is being sent
  bool of_step_ = false;                // the command under way belongs to the step
  MessageReader reader_;                // kReadMessage
  Time press_again_{};  // kJog: next command; kEstop: next repetition; kWait, kReadMessage: next question
  std::optional<std::string> failure_;
};

}  // namespace armature::cosim
