// SHA-256 of the integer columns of every tick: what a golden pins at 20 kHz without storing it.
#pragma once

#include <string>
#include <vector>

#include "cosim/text/sha256.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// The hashed text is that of a full-rate trace file cut after its integer columns: the header line, then one line a
// tick, '\n' ended. `cut -d, -f1-26 trace.csv | sha256sum` of a trace with every_ticks = 1 gives the same.
class IntegerDigest {
 public:
  IntegerDigest();
  void add(const TraceRow& row);
  [[nodiscard]] std::string hex();

 private:
  void flush();

  Sha256 sha256_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
};

}  // namespace armature::cosim
