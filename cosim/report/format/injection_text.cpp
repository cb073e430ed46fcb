#include "cosim/report/format/injection_text.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <variant>

#include "cosim/report/measure/fault_chain.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::string latency_text(Cycles from, Cycles to) {
  const double us = to_seconds(to - from) * 1e6;
  return us < 1000 ? fmt::format("{:.2f} us", us) : fmt::format("{:.3f} ms", us / 1000);
}

}  // namespace

std::string input_text(const InputSpec& input) {
  return fmt::format("pin {} = {}", input.pin, input.level ? 1 : 0);
}

std::string moment_text(const RunPlace& place) {
  return fmt::format("{:.6f} s (tick {}, cycle {})", to_seconds(place.at), place.tick, place.at.value());
}

std::string answer_text(const InjectedFault& fault) {
  std::string text;
  if (const auto* loss = std::get_if<PulseLoss>(&fault.spec.kind)) {
    text += fmt::format("{} of {} pulses lost, ", fault.lost_pulses, loss->count);
    text += fault.max_correction_pulses == 0
                ? "not corrected, "
                : fmt::format("corrected by up to {} pulses, ", fault.max_correction_pulses);
  }
  if (fault.underruns > 0) text += fmt::format("{} underruns, ", fault.underruns);
  if (fault.servo_off) {
    text += fmt::format("servo enables dropped after {}, ", latency_text(fault.when.at, *fault.servo_off));
  }
  if (!fault.fault) return text + "the controller reports no fault";
  const auto& [cause, where] = *fault.fault;
  return text + fmt::format("the controller reports {}{} after {}", word_of(cause),
                            where.axis == 0 ? std::string{} : fmt::format(" of axis {}", where.axis),
                            latency_text(fault.when.at, where.at));
}

std::string cause_text(const RunFacts& facts, const RunPlace& report) {
  std::string text;
  for (const InjectedFault& fault : causes_of(facts, report)) {
    text += fmt::format("{}{} {} cycle {}", text.empty() ? "" : ", and ", fault_text(fault.spec),
                        fault_duration_s(fault.spec.kind) ? "since" : "at", fault.when.at.value());
    if (fault.ended && *fault.ended <= report.at) text += fmt::format(" to cycle {}", fault.ended->value());
  }
  if (!text.empty()) return text;
  const double moved_deg = facts.moved_start_deg && report.axis > 0
                               ? facts.moved_start_deg->at(static_cast<std::size_t>(report.axis - 1))
                               : 0;
  return moved_deg == 0 ? "no fault of the scenario" : fmt::format("moved_start_deg of {} deg", number_text(moved_deg));
}

std::string first_fault_text(const RunFacts& facts) {
  const std::optional<FirstFault> first = first_fault(facts);
  if (!first) return {};
  std::string what = "the servo enables dropped without a report";
  if (first->what == FirstFault::What::kReported) what = word_of(first->cause);
  if (first->what == FirstFault::What::kBusError) what = abort_text(facts.bus_aborts.front());
  if (first->where.axis != 0) what += fmt::format(" of axis {}", first->where.axis);
  return fmt::format("{} at tick {}: {}", what, first->where.tick, cause_text(facts, first->where));
}

std::string abort_text(const BusAbortEvent& abort) {
  return fmt::format("core {} stopped: {} of 0x{:08X} answered {}", abort.core, abort.write ? "write" : "read",
                     abort.address, bus_error_name(abort.error));
}

std::string answer_text(const GivenInput& input, const CommandNames& names) {
  if (!input.accepted()) {
    return names.has_program() ? "no move and no line of a program waited for it" : "no move waited for it";
  }
  const std::string by =
      input.accepted_by ? fmt::format("move[{}]", *input.accepted_by) : names.line_text(*input.accepted_by_line);
  return fmt::format("{} accepted it after {}", by, latency_text(input.when.at, input.accepted_at));
}

}  // namespace armature::cosim
