// The file load.csv: what the cores did with their time.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

inline constexpr const char* kLoadHeader =
    "tick,time_s,core0_awake_cycles,core1_awake_cycles,core0_bus_cycles,core1_bus_cycles";

// These follow if the processor counts its instructions.
inline constexpr const char* kInstructionColumns = "core0_instructions,core1_instructions";
enum class CountsInstructions : std::uint8_t { kNo, kYes };

// One line for every tick that is a multiple of `every_ticks`, as in trace.csv. Each value is the largest of one tick
// since the line before. Tick 0 ends the start-up, which is no tick: its values are 0.
class LoadWriter {
 public:
  // Throws InputError naming the file when it cannot be written, as does close().
  LoadWriter(const std::filesystem::path& file, std::int64_t every_ticks,
             CountsInstructions counts = CountsInstructions::kNo);

  void write(const TraceRow& row);
  // Writes all lines so far to the file, so that they remain when this process is killed.
  void write_through() { stream_.flush(); }
  void close();

 private:
  std::filesystem::path path_;
  std::ofstream stream_;
  std::int64_t every_ticks_;
  bool counts_;
  std::array<CoreLoad, 2> largest_{};
};

}  // namespace armature::cosim
