// Writes load.csv of a run: what the cores did.
#pragma once

#include "cosim/run/run_listener.hpp"
#include "cosim/trace/load_writer.hpp"
#include "cosim/trace/trace_file.hpp"

namespace armature::cosim {

class LoadListener final : public RunListener {
 public:
  // Throws InputError when the file cannot be written, as does on_end().
  explicit LoadListener(const TraceFile& load, CountsInstructions counts = CountsInstructions::kNo)
      : writer_{load.file, load.every_ticks, counts} {}

  void on_row(const TraceRow& row, const IntegerDigest&) override { writer_.write(row); }
  void write_through() override { writer_.write_through(); }
  void on_end(const RunSummary&) override { writer_.close(); }

 private:
  LoadWriter writer_;
};

}  // namespace armature::cosim
