// Any bytes on the pendant's line, with gaps and with answers at any time. Input: steps, each a byte and what it needs.
#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>

#include "controller/pendant/parts/estop_detector.hpp"
#include "controller/pendant/protocol/admission.hpp"
#include "controller/pendant/protocol/bulk_receiver.hpp"
#include "controller/pendant/protocol/command_link.hpp"
#include "controller/pendant/protocol/crc8.hpp"
#include "controller/pendant/protocol/frame_receiver.hpp"

namespace armature::pendant {
namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

class Controller {
 public:
  void receive(std::uint8_t byte) {
    run_ = byte == kEstopByte ? run_ + 1 : 0;
    require(detector_.push(byte) == (run_ == kEstopRun));
    const std::optional<FrameBytes> bytes = receiver_.push(byte);
    if (!bytes) return;
    require(valid(*bytes, End::kController));
    if (kind_of(*bytes) == Kind::kBulk) return on_bulk(*bytes);
    on_command(decode(*bytes), *bytes);
  }
  void discard() { receiver_.discard(); }
  void answer(std::uint8_t status) {
    if (!link_.outstanding()) return;
    if (const auto reply = link_.answer(static_cast<Status>(status % kStatusNames.size()))) check(*reply);
    require(!link_.outstanding());
  }

 private:
  void on_bulk(const FrameBytes& bytes) {
    const BulkFrame bulk = decode_bulk(bytes);
    require(encode(bulk) == bytes);
    const std::size_t before = bulk_.text().size();
    if (const auto reply = bulk_.push(bulk)) check(*reply);
    require(bulk_.text().size() <= store_.size() && bulk_.text().size() - before <= BulkFrame::kCharacters);
  }

  void on_command(const Frame& command, const FrameBytes& bytes) {
    require(encode(command) == bytes);
    for (std::size_t state = 0; state < kStateNames.size(); ++state) {
      const Status strict = admission(command, static_cast<State>(state), Profile::kStrict);
      const Status extended = admission(command, static_cast<State>(state), Profile::kExtended);
      require(strict != Status::kOk || extended == Status::kOk);
    }
    if (begins_session(command) && session_ != command.payload) {
      session_ = command.payload;
      executed_.reset();
    }
    const bool was_outstanding = link_.outstanding();
    const CommandLink::Decision decision = link_.on_command(command);
    if (decision.reply) check(*decision.reply);
    if (!decision.execute) return;
    // Never while another one waits, and never the same one again in a session.
    require(!was_outstanding && !decision.reply && executed_ != command);
    executed_ = command;
    if (command.opcode == Opcode::kProgramBegin) static_cast<void>(bulk_.begin(command.payload));
  }

  // The pendant understands every reply.
  static void check(const Frame& reply) { require(valid(encode(reply), End::kPendant)); }

  EstopDetector detector_;
  int run_ = 0;
  FrameReceiver receiver_{End::kController};
  CommandLink link_;
  std::array<char, 64> store_{};
  BulkReceiver bulk_{store_};
  std::optional<std::int32_t> session_;
  std::optional<Frame> executed_;  // last, in this session
};

void send_with_crc(FuzzedDataProvider& input, Controller& controller) {
  FrameBytes bytes{};
  for (std::uint8_t& byte : bytes) byte = input.ConsumeIntegral<std::uint8_t>();
  bytes.back() = crc8(std::span{bytes}.first<kFrameBytes - 1>());
  for (const std::uint8_t byte : bytes) controller.receive(byte);
}

}  // namespace
}  // namespace armature::pendant

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace armature::pendant;
  FuzzedDataProvider input{data, size};
  Controller controller;
  while (input.remaining_bytes() > 0) {
    switch (input.ConsumeIntegralInRange<int>(0, 3)) {
      case 0:
        controller.receive(input.ConsumeIntegral<std::uint8_t>());
        break;
      case 1:
        send_with_crc(input, controller);
        break;
      case 2:
        controller.answer(input.ConsumeIntegral<std::uint8_t>());
        break;
      default:
        controller.discard();
        break;
    }
  }
  return 0;
}
