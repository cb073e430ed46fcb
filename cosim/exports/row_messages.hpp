// The rows of a trace as messages: joints, tool, frames of the links, load of the cores.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cosim/exports/mcap_writer.hpp"
#include "cosim/exports/run_times.hpp"
#include "cosim/recording/recorded_arm.hpp"
#include "cosim/recording/run_record.hpp"

namespace armature::cosim {

class RowMessages {
 public:
  // Both must outlive this. `load` is left out if it does not have the rows of the trace.
  RowMessages(const RunRecord& run, const std::optional<TraceTable>& load);

  [[nodiscard]] std::uint64_t time_ns(std::size_t row) const { return times_.of_row(row); }
  // The messages of this row. Rows come in their order.
  void write(std::size_t row, McapWriter& writer) const;

 private:
  // One kind of angles, of all joints.
  struct Side {
    std::vector<const NumberColumn*> angles;
    std::size_t joints_channel, tool_channel;
  };

  [[nodiscard]] std::string joints_text(const Side& side, std::size_t row) const;
  [[nodiscard]] std::string tool_text(const Side& side, std::size_t row) const;
  [[nodiscard]] std::string transforms_text(std::size_t row) const;
  [[nodiscard]] std::string load_text(std::size_t row) const;
  [[nodiscard]] double speed_deg_s(const NumberColumn& angle, std::size_t row) const;
  [[nodiscard]] std::string time_text(std::size_t row) const;

  RunTimes times_;
  std::size_t rows_;
  std::vector<Side> sides_;
  std::optional<RecordedArm> arm_;
  std::string frames_;                                  // transforms of the frames of the scenario, for the first row
  std::vector<std::vector<const NumberColumn*>> load_;  // cycles awake and on the bus, of both cores; empty: none
};

}  // namespace armature::cosim
