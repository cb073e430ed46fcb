#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "cosim/scenario/scenario_tables.hpp"
#include "cosim/text/byte_text.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr double kMinBaud = 50;
constexpr double kMaxBaud = 5'000'000;  // ten cycles a bit

// The text or hex of an entry.
bool read_bytes(TableReader& table, std::string& bytes) {
  const bool text = table.read("text", bytes, anything());
  const bool hex = read_hex(table, "hex", bytes);
  if (table.has("text") && table.has("hex")) table.problem("hex", "cannot stand beside text");
  if (!table.has("text") && !table.has("hex")) table.problem("text", "missing, expected the bytes to send, or hex");
  if ((text || hex) && bytes.empty()) table.problem(hex ? "hex" : "text", "expected at least one byte");
  return text || hex;
}

void require_fit(TableReader& table, const SerialSpec& serial, const std::string& bytes) {
  const unsigned limit = 1u << serial.data_bits;
  const auto beyond = std::ranges::find_if(bytes, [&](char c) { return static_cast<unsigned char>(c) >= limit; });
  if (beyond == bytes.end()) return;
  table.problem(table.has("hex") ? "hex" : "text",
                "expected bytes of serial.data_bits = " + std::to_string(serial.data_bits) + ", found 0x" +
                    hex_of_bytes({&*beyond, 1}));
}

}  // namespace

bool read_hex(TableReader& table, std::string_view key, std::string& bytes) {
  std::string digits;
  if (!table.read(key, digits, anything())) return false;
  auto read = bytes_of_hex(digits);
  if (!read) {
    table.problem(key,
                  "expected pairs of hexadecimal digits, such as \"48 69 0d\", found \"" + printable(digits) + "\"");
    return false;
  }
  bytes = *std::move(read);
  return true;
}

void read_serial(TableReader& table, SerialSpec& serial) {
  table.read("baud", serial.baud, between(kMinBaud, kMaxBaud, "bit/s"));
  table.read("data_bits", serial.data_bits, between(5, 8, "bits"));
  table.read("parity", serial.parity, one_of(kSerialParityNames));
  double stop_bits = 1;
  if (!table.read("stop_bits", stop_bits, anything())) return;
  if (stop_bits == 1 || stop_bits == 1.5 || stop_bits == 2) {
    serial.stop_bits = stop_bits;
  } else {
    table.problem("stop_bits", "expected 1, 1.5 or 2, found " + number_text(stop_bits));
  }
}

void read_serial_send(TableReader& table, const Scenario& scenario, SerialSendSpec& send) {
  send.line = table.line();
  read_at(table, scenario.duration_s, send.at_s);
  std::string fault;
  if (table.read("fault", fault, one_of(kSerialFaultNames))) {
    const auto name = std::find(kSerialFaultNames.begin(), kSerialFaultNames.end(), fault);
    send.fault = static_cast<SerialFault>(name - kSerialFaultNames.begin() + 1);
  } else if (table.has("fault")) {
    table.ignore_rest();
    return;
  }
  if (send.fault == SerialFault::kBreak) {
    table.read("break_s", send.break_s, above(0, 1, "s"), Need::kRequired);
    table.refuse({"text", "hex", "baud_error_percent"}, "a fault other than \"break\", or none");
    return;
  }
  table.refuse({"break_s"}, "fault = \"break\"");
  if (send.fault == SerialFault::kParity && scenario.serial && scenario.serial->parity == "none") {
    table.problem("fault", "needs a serial.parity other than \"none\"");
  }
  if (read_bytes(table, send.bytes) && scenario.serial) require_fit(table, *scenario.serial, send.bytes);
  table.read("baud_error_percent", send.baud_error_percent,
             between(-kMaxBaudErrorPercent, kMaxBaudErrorPercent, "percent"));
}

}  // namespace armature::cosim
