// What a person does to the cell of a live run beside the pendant: inputs of the tool, switches, the line of the
// emergency stop, faults. All of it happens through the script of the run, and is remembered for a run that repeats the
// session.
#pragma once

#include <string>
#include <vector>

#include "cosim/fault/fault_spec.hpp"
#include "cosim/run/run.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

class LiveCell final : public RunListener {
 public:
  // The run must outlive this and hear of nothing before this is added to it.
  explicit LiveCell(Run& run) : run_{run} {}

  // Inverts an input of the tool. `pin`: 1..kToolPins.
  void click_input(std::int64_t pin);
  // Holds a switch at the other level, or lets it go. `axis`: 1..6.
  void click_switch(int axis, AxisSwitch which);
  // Holds the line of the emergency stop low, or lets it go.
  void click_estop();
  // Begins now, which is its `at_s`.
  void cause(const FaultSpec& fault) { run_.add_action(fault); }

  // What is held: {"home": one bit an axis, "limit_pos", "limit_neg", "estop": true or false}.
  [[nodiscard]] Json held() const;
  // `fault=[...]` and `input=[...]`: all that has happened so far, also by the scenario. Overrides of the scenario
  // (--set) for a run that repeats this one.
  [[nodiscard]] std::vector<std::string> overrides() const;

  // RunListener
  void on_action(const ScriptAction& action, const RunPlace& place) override;

 private:
  void click(const FaultKind& held_now);
  void on_input(const InputSpec& input);
  void end_held(const FaultSpec& fault, Cycles at);

  Run& run_;
  std::vector<FaultSpec> held_;
  std::vector<FaultSpec> faults_;  // that have begun; of those that were held, with the duration that they had
  std::vector<InputSpec> inputs_;  // that have changed a level
};

}  // namespace armature::cosim
