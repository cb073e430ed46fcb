// Measures a run. Run has one, which hears of everything first.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "cosim/report/measure/run_facts.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// What the controller sends on the serial line: kept for the fact `serial_sent`, or forgotten, so that a run of hours
// does not grow.
enum class SentBytes : std::uint8_t { kKept, kForgotten };

class FactsListener final : public RunListener {
 public:
  explicit FactsListener(const Scenario& scenario, SentBytes sent_bytes = SentBytes::kKept);

  void on_row(const TraceRow& row, const IntegerDigest& digest) override;
  void on_event(const Event& event, const RunPlace& place) override;
  void on_action(const ScriptAction& action, const RunPlace& place) override;
  void on_signal(const Signal& signal, const RunPlace& place) override;

  // Of the run so far.
  [[nodiscard]] RunFacts facts() const { return facts_.facts(); }
  [[nodiscard]] const std::vector<FaultEvent>& faults() const { return facts_.faults(); }
  // The robot must have kinematics.
  [[nodiscard]] ToolPoint tool_point(const Telemetry& telemetry) const { return tool_->measure(telemetry); }

 private:
  RunFactsCollector facts_;
  SentBytes sent_bytes_;
  std::optional<ToolPointMeter> tool_;           // nullopt: the robot has no kinematics
  std::optional<Eigen::Vector3d> set_point_mm_;  // of the tool in the last row
  PerAxis<Radians> reference_{};                 // likewise, of the joints
};

}  // namespace armature::cosim
