#include <fmt/format.h>

#include <optional>

#include "controller/base/words.hpp"
#include "cosim/serial/serial_log.hpp"
#include "cosim/text/byte_order_mark.hpp"
#include "cosim/text/csv_line.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

enum Column : std::size_t { kTime, kDirection, kByte, kChar, kError, kBaudError, kBreak, kColumns };

std::string_view name_of(Column column) {
  std::string_view rest = kSerialLogHeader;
  for (std::size_t i = 0; i < column; ++i) rest.remove_prefix(rest.find(',') + 1);
  return rest.substr(0, rest.find(','));
}

class Row {
 public:
  Row(const std::string& file, int line, std::string_view text) : values_{file} {
    values_.set(line, text);
    if (values_.values().size() != kColumns) {
      fail(kTime, "expected 7 values as in the header, found another number of values");
    }
  }

  [[nodiscard]] std::string_view text(Column column) const { return values_[column]; }

  [[nodiscard]] double number(Column column, double min, double max) const {
    const std::optional<double> value = values_.number<double>(column);
    if (!value || !(*value >= min && *value <= max)) {
      fail(column, fmt::format("expected {} = {}..{}", name_of(column), min, max));
    }
    return *value;
  }

  [[nodiscard]] char byte() const {
    const std::optional<unsigned> value = values_.number<unsigned>(kByte, 16);
    if (!value || text(kByte).size() != 2) fail(kByte, "expected two hexadecimal digits");
    return static_cast<char>(*value);
  }

  [[noreturn]] void fail(Column column, const std::string& message) const {
    values_.fail(column, message + ", found \"" + printable(values_[column]) + "\"");
  }

 private:
  CsvLine values_;
};

SerialFault fault_of(const Row& row) {
  const std::string_view text = row.text(kError);
  if (text.empty()) return SerialFault::kNone;
  const auto fault = enumerator_of<SerialFault>(text);
  if (fault && *fault != SerialFault::kNone) return *fault;
  row.fail(kError, "expected nothing, \"framing\", \"parity\" or \"break\"");
}

// None for a row that the controller sent.
std::optional<SerialSendSpec> send_of(const Row& row, int line, const SerialSpec& serial) {
  constexpr double kLongestS = 86'400;
  if (row.text(kDirection) == "tx") return std::nullopt;
  if (row.text(kDirection) != "rx") row.fail(kDirection, "expected \"rx\" or \"tx\"");
  SerialSendSpec send;
  send.line = line;
  send.at_s = row.number(kTime, 0, kLongestS);
  send.fault = fault_of(row);
  send.baud_error_percent = row.number(kBaudError, -kMaxBaudErrorPercent, kMaxBaudErrorPercent);
  if (send.fault == SerialFault::kBreak) {
    send.break_s = row.number(kBreak, 0, kLongestS);
    return send;
  }
  if (!row.text(kBreak).empty()) row.fail(kBreak, "expected break_s of a break only");
  if (send.fault == SerialFault::kParity && serial.parity == "none") {
    row.fail(kError, "expected no wrong parity on a line of serial.parity = \"none\"");
  }
  send.bytes = row.byte();
  if (static_cast<unsigned char>(send.bytes[0]) >= 1u << serial.data_bits) {
    row.fail(kByte, fmt::format("expected a byte of serial.data_bits = {}", serial.data_bits));
  }
  return send;
}

}  // namespace

std::vector<SerialSendSpec> parse_serial_log(const std::filesystem::path& file, std::string_view content,
                                             const SerialSpec& serial) {
  const std::string name = file.string();
  std::vector<SerialSendSpec> sends;
  std::string_view rest = without_byte_order_mark(content);
  for (int line = 1; !rest.empty(); ++line) {
    const std::string_view text = pop_line(rest);
    if (line > 1) {
      const Row row{name, line, text};
      const auto send = send_of(row, line, serial);
      if (!send) continue;
      if (!sends.empty() && send->at_s < sends.back().at_s) row.fail(kTime, "expected a time not before the last one");
      sends.push_back(*send);
    } else if (text != kSerialLogHeader) {
      throw InputError{Problem{name, Origin{1, 1, {}}, {}, "expected the header " + std::string{kSerialLogHeader}}};
    }
  }
  if (content.empty()) throw InputError{name, "is empty, expected the header " + std::string{kSerialLogHeader}};
  return sends;
}

}  // namespace armature::cosim
