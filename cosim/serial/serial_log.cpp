#include "cosim/serial/serial_log.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "cosim/text/input_error.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

std::string serial_text(std::uint8_t byte) {
  switch (byte) {
    case '\r':
      return "\\r";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    case '\\':
      return "\\\\";
    default:
      break;
  }
  const bool plain = byte >= 0x20 && byte < 0x7F && byte != ',' && byte != '"';
  return plain ? std::string{static_cast<char>(byte)} : fmt::format("\\x{:02X}", byte);
}

namespace {

std::string error_text(const SerialEvent& event) {
  if (event.is_break) return "break";
  std::string text;
  if (event.parity_error) text = "parity";
  if (event.framing_error) text += text.empty() ? "framing" : " framing";
  return text;
}

std::string percent_text(std::int32_t ppm) {
  const std::int32_t size = std::abs(ppm);
  return fmt::format("{}{}.{:04}", ppm < 0 ? "-" : "", size / 10'000, size % 10'000);
}

}  // namespace

std::string serial_log_row(const SerialEvent& event) {
  const bool rx = event.direction == SerialDirection::kRx;
  return fmt::format("{},{},{:02X},{},{},{},{}", seconds_text(event.at), rx ? "rx" : "tx", event.byte,
                     serial_text(event.byte), error_text(event),
                     rx ? percent_text(event.baud_error_ppm) : std::string{},
                     rx && event.is_break ? seconds_text(event.break_duration) : std::string{});
}

SerialLog::SerialLog(const std::filesystem::path& file) : file_{file.string()} {
  errno = 0;
  stream_.open(file, std::ios::binary | std::ios::trunc);
  require_written();
  stream_ << kSerialLogHeader << '\n';
}

void SerialLog::write(const SerialEvent& event) {
  stream_ << serial_log_row(event) << '\n';
}

void SerialLog::write_through() {
  errno = 0;
  stream_.flush();
  require_written();
}

void SerialLog::close() {
  errno = 0;
  stream_.close();
  require_written();
}

void SerialLog::require_written() const {
  if (!stream_) throw InputError{file_, std::string{"cannot write: "} + std::strerror(errno)};
}

}  // namespace armature::cosim
