// trace.csv of a run, in memory: it is taken back together with the process of the run, which a file would not be.
#pragma once

#include <cstddef>
#include <string>

#include "cosim/report/measure/tool_point.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/trace_lines.hpp"

namespace armature::cosim {

class TraceText final : public RunListener {
 public:
  explicit TraceText(const Scenario& scenario)
      : lines_{scenario.trace.every_ticks, tool_columns(scenario)}, text_{lines_.header()} {}

  void on_row(const TraceRow& row, const IntegerDigest& digest) override {
    if (!lines_.has(row)) return;
    const std::size_t used = text_.size();
    text_.resize(used + TraceLines::kMaxText);
    const char* const end = lines_.append(text_.data() + used, row, digest);
    text_.resize(static_cast<std::size_t>(end - text_.data()));
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  TraceLines lines_;
  std::string text_;
};

}  // namespace armature::cosim
