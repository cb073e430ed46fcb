// trace.csv of a run, in memory: it is taken back together with the process of the run, which a file would not be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "cosim/report/measure/tool_point.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/csv_row.hpp"

namespace armature::cosim {

class TraceText final : public RunListener {
 public:
  explicit TraceText(const Scenario& scenario)
      : every_ticks_{scenario.trace.every_ticks},
        tool_columns_{tool_columns(scenario)},
        text_{trace_header(tool_columns_) + '\n'} {}

  void on_row(const TraceRow& row, const IntegerDigest& digest) override {
    if (row.tick % every_ticks_ != 0) return;
    const std::size_t used = text_.size();
    text_.resize(used + kMaxRowText);
    const char* const end = append_row(text_.data() + used, row, digest.prefix(), tool_columns_);
    text_.resize(static_cast<std::size_t>(end - text_.data()));
    text_ += '\n';
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::int64_t every_ticks_;
  ToolColumns tool_columns_;
  std::string text_;
};

}  // namespace armature::cosim
