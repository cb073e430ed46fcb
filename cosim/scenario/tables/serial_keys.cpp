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
      .text = "The table connects the serial line of the controller and sets the format of both directions.",
      .keys = {
          key("baud", &SerialSpec::baud, between(kMinBaud, kMaxBaud, "bit/s"), "The far end sends at this rate."),
          key("data_bits", &SerialSpec::data_bits, between(5, 8, "bits"), "A character has so many data bits."),
          key("parity", &SerialSpec::parity, one_of(kSerialParityNames), "A character has this parity bit."),
          key("stop_bits", &SerialSpec::stop_bits, one_of_numbers({1, 1.5, 2}),
              "A character ends with so many stop bits."),
      }};
  return kTable;
}

const KeyTable<SerialSendSpec>& serial_send_keys() {
  static const Condition kBytes = unless("fault", "break");
  static const KeyTable<SerialSendSpec> kTable{
      .text = "Each table sends something to the controller. It needs a table `[serial]`.",
      .keys = {
          at_key<SerialSendSpec>("The transmission begins at this time, or when the one before it has ended."),
          named_key(
              "fault", &SerialSendSpec::fault, kSerialFaultNames,
              "What is wrong with every byte. `framing`: the stop bit is missing; the line is then high for a bit. "
              "`parity`: the parity bit is wrong. `break`: there are no bytes; the line is low for `break_s` and "
              "then high for a bit.",
              SerialFault::kFraming)
              .without("no fault")
              .checked(check_fault),
          key("text", &SerialSendSpec::bytes, anything(), "The far end sends these bytes one after the other.")
              .required()
              .only(kBytes)
              .checked(check_bytes),
          set_key<SerialSendSpec, std::string>(
              "hex", [](SerialSendSpec& send, const std::string& digits) { return read_hex(digits, send.bytes); },
              anything(), "The same as `text`, in hexadecimal digits such as \"48 69 0d\".")
              .only(kBytes)
              .replaces("text")
              .pattern(kHexPattern)
              .checked(check_bytes),
          key("baud_error_percent", &SerialSendSpec::baud_error_percent,
              between(-kMaxBaudErrorPercent, kMaxBaudErrorPercent, "percent"),
              "The rate of the far end differs from `baud` by this much.")
              .only(kBytes),
          key("break_s", &SerialSendSpec::break_s, above(0, 1, "s"), "The line is low for this time.")
              .required()
              .only(when("fault", {"break"})),
      }};
  return kTable;
}

}  // namespace armature::cosim
