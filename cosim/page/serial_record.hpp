// The log of the serial line that a run wrote.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace armature::cosim {

// Characters that follow each other closely in one direction, as text.
struct SerialRecord {
  double time_s = 0;      // of the first one
  std::string direction;  // rx: to the controller; tx: from it
  std::string text;
  std::string error;  // words of its errors; empty: none
};

// Empty if there is no such file. Throws InputError when it is malformed.
[[nodiscard]] std::vector<SerialRecord> read_serial_record(const std::filesystem::path& file);

}  // namespace armature::cosim
