#include "cosim/trace/load_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "cosim/text/input_error.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/decimal_text.hpp"

namespace armature::cosim {
namespace {

void require(const std::ofstream& stream, const std::filesystem::path& file) {
  if (!stream) throw InputError{file.string(), std::string{"cannot write: "} + std::strerror(errno)};
}

char* comma(char* out) {
  *out++ = ',';
  return out;
}

}  // namespace

LoadWriter::LoadWriter(const std::filesystem::path& file, std::int64_t every_ticks, CountsInstructions counts)
    : path_{file},
      stream_{file, std::ios::binary},
      every_ticks_{every_ticks},
      counts_{counts == CountsInstructions::kYes} {
  require(stream_, path_);
  stream_ << kLoadHeader;
  if (counts_) stream_ << ',' << kInstructionColumns;
  stream_ << '\n';
}

void LoadWriter::write(const TraceRow& row) {
  for (std::size_t core = 0; row.tick > 0 && core < largest_.size(); ++core) {
    CoreLoad& largest = largest_[core];
    largest.awake_cycles = std::max(largest.awake_cycles, row.load[core].awake_cycles);
    largest.bus_cycles = std::max(largest.bus_cycles, row.load[core].bus_cycles);
    largest.instructions = std::max(largest.instructions, row.load[core].instructions);
  }
  if (row.tick % every_ticks_ != 0) return;
  std::array<char, 8 * (kMaxIntegerText + 1) + kTimeDigits> line{};
  char* end = append_seconds(comma(append_integer(line.data(), row.tick)), Cycles{row.cycle});
  for (const std::int64_t cycles :
       {largest_[0].awake_cycles, largest_[1].awake_cycles, largest_[0].bus_cycles, largest_[1].bus_cycles}) {
    end = append_integer(comma(end), cycles);
  }
  for (std::size_t core = 0; counts_ && core < largest_.size(); ++core) {
    end = append_integer(comma(end), largest_[core].instructions);
  }
  *end++ = '\n';
  stream_.write(line.data(), end - line.data());
  largest_ = {};
}

void LoadWriter::close() {
  stream_.close();
  require(stream_, path_);
}

}  // namespace armature::cosim
