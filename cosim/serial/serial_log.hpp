// serial.csv: every character and break on the line, in the order of simulated time, the same bytes on every machine.
//
//   time_s,direction,byte,char,error,baud_error_percent,break_s
//   0.01000000,rx,41,A,,0.0000,
//   0.01017354,tx,0D,\r,parity framing,,
//
// scenarios/RESULTS.md describes the file for users. `direction` is seen from the controller: rx is to the controller.
// `time_s` is SerialEvent::at, in whole cycles of 20 ns. `char` is the byte if it is printable, else an escape: \r, \n,
// \t, \\, \xNN. The comma and the quote are escaped, too, so that no field needs quoting. `error` is empty, "break",
// "parity", "framing" or "parity framing". The last two columns are set in rx rows only, break_s for breaks only. A
// program that reads the file uses `byte`, not `char`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/serial/serial_event.hpp"
#include "cosim/serial/serial_spec.hpp"

namespace armature::cosim {

inline constexpr std::string_view kSerialLogHeader = "time_s,direction,byte,char,error,baud_error_percent,break_s";

// `char` of a row.
[[nodiscard]] std::string serial_text(std::uint8_t byte);

// One row, without the end of the line.
[[nodiscard]] std::string serial_log_row(const SerialEvent& event);

class SerialLog {
 public:
  // Throws InputError when the file cannot be written, as does close().
  explicit SerialLog(const std::filesystem::path& file);
  void write(const SerialEvent& event);
  void write_through();  // as CsvWriter::write_through()
  void close();

 private:
  void require_written() const;

  std::string file_;
  std::ofstream stream_;
};

// Converts the rx rows of the text of such a file to a script. With the same format the line repeats the same levels,
// cycle by cycle. Throws InputError with file, line and column when the text is malformed or does not fit the format.
[[nodiscard]] std::vector<SerialSendSpec> parse_serial_log(const std::filesystem::path& file, std::string_view text,
                                                           const SerialSpec& serial);

}  // namespace armature::cosim
