#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <system_error>

#include "controller/base/words.hpp"
#include "cosim/serial/serial_log.hpp"
#include "cosim/text/byte_order_mark.hpp"
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
  Row(const std::string& file, int line, std::string_view text) : file_{file}, line_{line}, text_{text} {
    std::string_view rest = text;
    while (true) {
      const std::size_t comma = rest.find(',');
      fields_.push_back(rest.substr(0, comma));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    if (fields_.size() != kColumns) {
      fields_.resize(kColumns, text_.substr(text_.size()));
      fail(kTime, "expected 7 values as in the header, found another number of values");
    }
  }

  [[nodiscard]] std::string_view text(Column column) const { return fields_[column]; }

  [[nodiscard]] double number(Column column, double min, double max) const {
    const std::string_view field = fields_[column];
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    const bool whole = error == std::errc{} && end == field.data() + field.size();
    if (!whole || !(value >= min && value <= max)) {
      fail(column, fmt::format("expected {} = {}..{}", name_of(column), min, max));
    }
    return value;
  }

  [[nodiscard]] char byte() const {
    const std::string_view field = fields_[kByte];
    unsigned value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value, 16);
    if (error != std::errc{} || end != field.data() + field.size() || field.size() != 2) {
      fail(kByte, "expected two hexadecimal digits");
    }
    return static_cast<char>(value);
  }

  [[noreturn]] void fail(Column column, const std::string& message) const {
    const auto column_number = static_cast<int>(fields_[column].data() - text_.data()) + 1;
    throw InputError{Problem{
        file_, Origin{line_, column_number, {}}, {}, message + ", found \"" + printable(fields_[column]) + "\""}};
  }

 private:
  const std::string& file_;
  int line_;
  std::string_view text_;
  std::vector<std::string_view> fields_;
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
    const std::size_t end = rest.find('\n');
    std::string_view text = rest.substr(0, end);
    if (text.ends_with('\r')) text.remove_suffix(1);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
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
