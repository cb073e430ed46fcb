// The controller's end of the pendant's line without an arm: it notes what it executes and answers as it is told.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/pendant/parts/estop_detector.hpp"
#include "controller/pendant/protocol/bulk_receiver.hpp"
#include "controller/pendant/protocol/command_link.hpp"
#include "controller/pendant/protocol/frame.hpp"
#include "controller/pendant/protocol/frame_receiver.hpp"
#include "controller/pendant/protocol/message_pages.hpp"
#include "cosim/pendant/operator_link.hpp"

namespace armature::cosim::test {

struct FakeController {
  using Frame = pendant::Frame;
  using Opcode = pendant::Opcode;

  // Passes bytes both ways for `duration` from `now` on, every millisecond.
  void run(OperatorLink& link, OperatorLink::Time& now, OperatorLink::Time duration) {
    for (const OperatorLink::Time end = now + duration; now < end; now += OperatorLink::Time{1000}) {
      std::vector<std::uint8_t> bytes;
      link.poll(now, bytes);
      for (const std::uint8_t byte : bytes) receive(byte);
      link.receive(out);
      out.clear();
    }
  }

  void receive(std::uint8_t byte) {
    if (deaf) return;
    if (estop.push(byte)) {
      ++estops;
      set_state(pendant::State::kEstop);
    }
    const auto bytes = receiver.push(byte);
    if (!bytes) return;
    if (pendant::kind_of(*bytes) == pendant::Kind::kBulk) {
      if (const auto reply = bulk.push(pendant::decode_bulk(*bytes))) put(*reply);
      return;
    }
    const Frame command = pendant::decode(*bytes);
    const auto decision = commands.on_command(command);
    if (decision.reply) put(*decision.reply);
    if (!decision.execute) return;
    executed.push_back(command);
    if (command.opcode == Opcode::kProgramBegin) static_cast<void>(bulk.begin(command.payload));
    const bool asks = command.opcode == Opcode::kGetStatus;
    if (const auto reply = commands.answer(status, asks ? pages[command.parameter] : payload)) put(*reply);
  }

  void set_state(pendant::State state, std::int32_t more = 0) {
    put({.kind = pendant::Kind::kTelemetry,
         .opcode = Opcode::kGetStatus,
         .parameter = 0,
         .payload = static_cast<std::int32_t>(state) + more});
  }

  // A message of the program, as pages and as telemetry.
  void say(pendant::MessageKind kind, std::int32_t place, std::string_view text) {
    const pendant::MessageHeader header{
        .number = ++messages, .kind = kind, .length = static_cast<std::uint8_t>(text.size())};
    pages[static_cast<std::size_t>(pendant::Page::kMessage)] = page_of(header);
    pages[static_cast<std::size_t>(pendant::Page::kMessageLine)] = place;
    for (std::size_t i = 0; i < pendant::kTextPages; ++i)
      pages[static_cast<std::size_t>(pendant::Page::kMessageText) + i] = pendant::text_page(text, i);
    put({.kind = pendant::Kind::kTelemetry,
         .opcode = Opcode::kGetStatus,
         .parameter = static_cast<std::uint8_t>(pendant::Page::kMessage),
         .payload = page_of(header)});
  }

  void put(const Frame& frame) {
    for (const std::uint8_t byte : encode(frame)) out.push_back(byte);
  }

  // How often a command was executed.
  [[nodiscard]] std::size_t count(Opcode opcode) const {
    std::size_t found = 0;
    for (const Frame& frame : executed) found += frame.opcode == opcode ? 1 : 0;
    return found;
  }

  std::array<char, 4096> store{};
  pendant::FrameReceiver receiver{pendant::End::kController};
  pendant::CommandLink commands;
  pendant::BulkReceiver bulk{store};
  pendant::EstopDetector estop;
  std::vector<std::uint8_t> out;
  std::vector<Frame> executed;
  pendant::Status status = pendant::Status::kOk;  // of the replies
  std::int32_t payload = 0;
  std::array<std::int32_t, pendant::kPages> pages{};  // for get_status
  std::uint16_t messages = 0;
  int estops = 0;
  bool deaf = false;
};

}  // namespace armature::cosim::test
