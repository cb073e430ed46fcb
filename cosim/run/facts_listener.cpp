#include "cosim/run/facts_listener.hpp"

#include <variant>

#include "controller/base/overloaded.hpp"
#include "cosim/run/bus_abort_event.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

FactsListener::FactsListener(const Scenario& scenario, SentBytes sent_bytes)
    : facts_{scenario.robot, scenario.expect.settled_counts, scenario.conveyor, CommandNames{scenario}},
      sent_bytes_{sent_bytes} {
  if (scenario.drop_out_us) facts_.set_drop_out(to_cycles(*scenario.drop_out_us * 1e-6));
  if (scenario.moved_start_deg) facts_.set_moved_start(*scenario.moved_start_deg);
  if (scenario.robot.kinematics) tool_.emplace(scenario);
}

void FactsListener::on_row(const TraceRow& row, const IntegerDigest&) {
  facts_.add(row);
  if (!tool_) return;
  if (row.tool_point) {
    set_point_mm_ = row.tool_point->reference_mm;
  } else if (!set_point_mm_ || row.telemetry.reference != reference_) {
    set_point_mm_ = tool_->set_point_mm(row.telemetry);
  }
  reference_ = row.telemetry.reference;
  facts_.add_tool(row, *set_point_mm_);
}

void FactsListener::on_event(const Event& event, const RunPlace& place) {
  facts_.on_event(event, place.at);
}

void FactsListener::on_action(const ScriptAction& action, const RunPlace& place) {
  std::visit(Overloaded{
                 [&](const CommandSpec& command) { facts_.add(command); },
                 [&](const FaultSpec& fault) { facts_.add(fault, place); },
                 [&](const FaultEnd& end) { facts_.end(end.fault, place.at); },
                 [&](const InputSpec& input) { facts_.add(input, place); },
                 [](const StreamStep&) {},
                 [](const PartStep&) {},
             },
             action);
}

void FactsListener::on_signal(const Signal& signal, const RunPlace& place) {
  std::visit(Overloaded{
                 [&](const OutputLevel& output) {
                   facts_.add(OutputChange{.pin = output.pin, .level = output.level, .at = place.at});
                 },
                 [&](const ServoEnables& enables) { facts_.add_servo_enables(enables.levels, place.at); },
                 [&](const BusAbort& abort) { facts_.add(bus_abort_event(abort, place)); },
                 [&](const SerialEvent& event) {
                   if (event.direction != SerialDirection::kTx || sent_bytes_ == SentBytes::kForgotten) return;
                   facts_.add_serial(event.byte, event.has_error(), event.is_break);
                 },
                 [](const PendantStepDone&) {},
             },
             signal);
}

}  // namespace armature::cosim
