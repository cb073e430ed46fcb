// The faults of a scenario that wait for a condition, `when`. They are judged at each trigger, by what a row of the
// trace has, so that all engines agree.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

class FaultConditions {
 public:
  explicit FaultConditions(const Scenario& scenario);

  // The move of the scenario with this index has begun.
  void on_move(std::uint32_t index) { moves_begun_.push_back(index); }

  // Removes and returns the faults whose condition holds at the trigger of this row.
  [[nodiscard]] std::vector<FaultSpec> due(const TraceRow& row);

 private:
  [[nodiscard]] bool holds(const FaultSpec& fault, const TraceRow& row) const;

  PerAxis<double> counts_per_deg_{};  // of the joint, signed
  std::vector<FaultSpec> waiting_;
  std::vector<std::uint32_t> moves_begun_;  // since the trigger before
  PerAxis<std::int64_t> motor_counts_{};    // at the trigger before
  PerAxis<Radians> reference_{};
  bool has_before_ = false;  // there was one
};

}  // namespace armature::cosim
