// [serial] and [[serial_send]]: the far end of the controller's UART.
#include <algorithm>
#include <string>

#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/byte_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr double kMinBaud = 50;
constexpr double kMaxBaud = 5'000'000;  // ten cycles a bit

std::string check_bytes(const SerialSendSpec& send, const KeyContext& context) {
  if (send.bytes.empty()) return "expected at least one byte";
  if (!context.scenario->serial) return {};
  const std::int64_t bits = context.scenario->serial->data_bits;
  const unsigned limit = 1u << bits;
  const auto beyond = std::ranges::find_if(send.bytes, [&](char c) { return static_cast<unsigned char>(c) >= limit; });
  if (beyond == send.bytes.end()) return {};
  return "expected bytes of serial.data_bits = " + std::to_string(bits) + ", found 0x" + hex_of_bytes({&*beyond, 1});
}

std::string check_fault(const SerialSendSpec& send, const KeyContext& context) {
  const bool parity = context.scenario->serial && context.scenario->serial->parity != "none";
  if (send.fault != SerialFault::kParity || !context.scenario->serial || parity) return {};
  return "needs a serial.parity other than \"none\"";
}

}  // namespace

std::string read_hex(const std::string& digits, std::string& bytes) {
  if (auto read = bytes_of_hex(digits)) {
    bytes = *std::move(read);
    return {};
  }
  return "expected pairs of hexadecimal digits, such as \"48 69 0d\", found \"" + printable(digits) + "\"";
}

const KeyTable<SerialSpec>& serial_keys() {
  static const KeyTable<SerialSpec> kTable{
      .text =
          "Connects the serial line of the controller to a simulated far end. The keys set the format of both "
          "directions.",
      .keys = {
          key("baud", &SerialSpec::baud, between(kMinBaud, kMaxBaud, "bit/s"), "Bit rate of the far end."),
          key("data_bits", &SerialSpec::data_bits, between(5, 8, "bits"), "Data bits of a character."),
          key("parity", &SerialSpec::parity, one_of(kSerialParityNames), "Parity bit of a character."),
          key("stop_bits", &SerialSpec::stop_bits, one_of_numbers({1, 1.5, 2}), "Stop bits of a character."),
      }};
  return kTable;
}

const KeyTable<SerialSendSpec>& serial_send_keys() {
  static const Condition kBytes = unless("fault", {"break"});
  static const KeyTable<SerialSendSpec> kTable{
      .text = "Each table is one transmission of the far end to the controller.",
      .keys = {
          at_key<SerialSendSpec>(
              "Time at which the transmission begins. It begins later if the transmission before it has not ended."),
          named_key("fault", &SerialSendSpec::fault,
                    "Error in every byte of the transmission. `framing`: the stop bit is low, and the line is high for "
                    "one bit after it. `parity`: the parity bit is wrong. `break`: the line is low for `break_s` "
                    "instead of bytes, and then high for one bit.",
                    SerialFault::kFraming)
              .without("no fault")
              .checked(check_fault),
          key("text", &SerialSendSpec::bytes, anything(), "Bytes that the far end sends.")
              .required()
              .only(kBytes)
              .checked(check_bytes),
          set_key<SerialSendSpec, std::string>(
              "hex", [](SerialSendSpec& send, const std::string& digits) { return read_hex(digits, send.bytes); },
              anything(), "Bytes that the far end sends, as hexadecimal digits such as \"48 69 0d\".")
              .only(kBytes)
              .replaces("text")
              .pattern(kHexPattern)
              .checked(check_bytes),
          key("baud_error_percent", &SerialSendSpec::baud_error_percent,
              between(-kMaxBaudErrorPercent, kMaxBaudErrorPercent, "percent"),
              "Deviation of the bit rate of the far end from `baud`.")
              .only(kBytes),
          key("break_s", &SerialSendSpec::break_s, above(0, 1, "s"), "Time for which the line is low.")
              .required()
              .only(when("fault", {"break"})),
      }};
  return kTable;
}

}  // namespace armature::cosim
