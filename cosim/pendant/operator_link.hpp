// The pendant's end of the line for a person: sends what he presses, keeps the link alive, and remembers what the
// controller reports.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/pendant/protocol/frame.hpp"
#include "controller/pendant/protocol/frame_receiver.hpp"
#include "cosim/pendant/bulk_sender.hpp"
#include "cosim/pendant/command_sender.hpp"
#include "cosim/pendant/message_reader.hpp"

namespace armature::cosim {

class OperatorLink {
 public:
  using Time = CommandSender::Time;
  // A simulated controller may be several times slower than real time.
  static constexpr Time kRepeatAfter{150'000};
  static constexpr Time kJogEvery{25'000};  // the controller stops a jog 100 ms after the last command
  static constexpr Time kTelemetryPeriod{50'000};
  static constexpr std::size_t kMaxWaiting = 16;   // commands
  static constexpr std::size_t kMaxMessages = 32;  // the oldest ones are dropped

  // `session`: a number that the last pendant on this line did not have.
  explicit OperatorLink(std::int32_t session) : session_{session & pendant::kLargestPayload} {}

  void receive(std::span<const std::uint8_t> bytes);
  // Appends the bytes to send at the time `now`, which never decreases.
  void poll(Time now, std::vector<std::uint8_t>& out);

  // Sends a command after those that wait; false when too many wait or there is no link.
  bool press(const pendant::Frame& command);
  // How many commands can be added to those that wait.
  [[nodiscard]] std::size_t room() const { return kMaxWaiting - std::min(waiting_.size(), kMaxWaiting); }
  // Jogs until the time `until`, in place of another jog. `velocity`: 0.01 % of the speed of jogs.
  void jog(std::uint8_t axis, std::int32_t velocity, Time until);
  void release_jog();
  // Sends the emergency stop until the controller reports it, and drops the commands that wait.
  void press_estop();
  // The person is gone: drops the commands that wait, and stops the arm. A program is held; with the profile `strict`
  // only the emergency stop ends it. Call it again while the arm moves: the state that is known here may be old.
  void let_go();
  // Sends a program. False while another one is sent or without a link. Every character must be below 128.
  bool download(pendant::Content kind, std::string name, std::string text);

  [[nodiscard]] bool connected() const { return in_session_; }
  // The page of the telemetry that came last; 0 before the first.
  [[nodiscard]] std::int32_t page(std::uint8_t number) const { return pages_[number]; }
  [[nodiscard]] std::int32_t page(pendant::Page first, std::size_t offset = 0) const {
    return pages_[static_cast<std::size_t>(first) + offset];
  }
  // Nothing before the first telemetry.
  [[nodiscard]] std::optional<pendant::State> state() const;
  [[nodiscard]] bool drives_on() const { return pendant::kStateDrivesOn.of(page(pendant::Page::kState)) != 0; }
  [[nodiscard]] bool extended() const { return pendant::kStateExtended.of(page(pendant::Page::kState)) != 0; }
  [[nodiscard]] int coordinates() const { return pendant::kStateCoordinates.of(page(pendant::Page::kState)); }
  // True when a program was sent from here, whatever became of it.
  [[nodiscard]] bool has_sent() const { return has_sent_; }
  // The number that a program has in the controller, 0 for G-code; none: it was not sent. Without has_sent() every
  // program is taken for the one that the controller has.
  [[nodiscard]] std::optional<std::size_t> job_of(std::string_view name) const;
  // True when the controller has confirmed a breakpoint; `place`: as the page `line` has it.
  [[nodiscard]] bool has_breakpoint(std::int32_t place) const { return breakpoints_.contains(place); }
  [[nodiscard]] const std::set<std::int32_t>& breakpoints() const { return breakpoints_; }
  [[nodiscard]] bool downloading() const { return transfer_ != Transfer::kNone; }
  [[nodiscard]] bool estop_pressed() const { return estop_pressed_; }
  // What the program of the controller said last; none: nothing since it began.
  [[nodiscard]] const std::optional<PendantMessage>& program_message() const { return reader_.message(); }
  // What became of commands, and what the program said, the newest last.
  [[nodiscard]] const std::deque<std::string>& messages() const { return messages_; }
  void say(std::string message);

 private:
  enum class Transfer : std::uint8_t { kNone, kBegin, kText, kCommit };

  void on_frame(const pendant::Frame& frame);
  void on_reply(const pendant::Frame& reply);
  void continue_transfer(const pendant::Frame& reply);
  void remember_program(const pendant::Frame& reply);
  void forget_programs();
  void remember_breakpoint();
  void remember_page(const pendant::Frame& reply);
  // The next command to send, if there is one.
  [[nodiscard]] std::optional<pendant::Frame> next_command(Time now);
  void drop_everything();

  std::int32_t session_;
  bool in_session_ = false;
  bool asked_for_telemetry_ = false;
  Time next_try_{};  // to begin a session
  pendant::FrameReceiver receiver_{pendant::End::kPendant};
  CommandSender sender_{kRepeatAfter};
  pendant::Frame sent_{};  // the last command
  Time sent_at_{};
  Time now_{};
  std::deque<pendant::Frame> waiting_;
  std::optional<pendant::Frame> jog_;
  Time jog_until_{}, jog_next_{};
  bool estop_pressed_ = false;
  Time estop_next_{};
  Transfer transfer_ = Transfer::kNone;
  std::optional<BulkSender> text_;
  pendant::Content kind_{};  // of the program under way
  std::string name_;         // of it
  bool has_sent_ = false;
  bool gcode_loaded_ = false;        // its text is overwritten by the next transfer
  std::vector<std::string> loaded_;  // by number of the job
  std::set<std::int32_t> breakpoints_;
  std::array<std::int32_t, pendant::kPages> pages_{};
  bool telemetry_came_ = false;
  MessageReader reader_;
  std::deque<std::string> messages_;
};

}  // namespace armature::cosim
