// A file with rows of a run: where it is, and its rate.
#pragma once

#include <cstdint>
#include <filesystem>

namespace armature::cosim {

struct TraceFile {
  std::filesystem::path file;
  std::int64_t every_ticks = 1;  // it has the ticks that are multiples of this
};

}  // namespace armature::cosim
