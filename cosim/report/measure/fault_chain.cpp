#include "cosim/report/measure/fault_chain.hpp"

#include <algorithm>
#include <iterator>

namespace armature::cosim {
namespace {

// Of the latest reset before this time; 0: there was none.
Cycles reset_before(const RunFacts& facts, Cycles at) {
  Cycles reset{};
  for (const Cycles one : facts.resets) {
    if (one < at) reset = one;
  }
  return reset;
}

bool lasts_beyond(const InjectedFault& fault, Cycles reset) {
  if (fault.when.at >= reset) return true;
  return fault_duration_s(fault.spec.kind) && fault.ended.value_or(reset) >= reset;
}

}  // namespace

std::vector<InjectedFault> causes_of(const RunFacts& facts, const RunPlace& report) {
  const Cycles reset = reset_before(facts, report.at);
  const auto select = [&](auto wanted) {
    std::vector<InjectedFault> causes;
    std::ranges::copy_if(facts.injected_faults, std::back_inserter(causes), [&](const InjectedFault& fault) {
      return fault.when.at <= report.at && wanted(fault, fault_axis(fault.spec.kind));
    });
    return causes;
  };
  for (const bool recent : {true, false}) {
    const auto counts = [&](const InjectedFault& fault) { return !recent || lasts_beyond(fault, reset); };
    std::vector<InjectedFault> causes = select([&](const InjectedFault& fault, std::optional<int> axis) {
      return counts(fault) && axis && *axis == report.axis;
    });
    if (causes.empty()) {
      causes = select([&](const InjectedFault& fault, std::optional<int> axis) { return counts(fault) && !axis; });
    }
    if (causes.empty()) causes = select([&](const InjectedFault& fault, std::optional<int>) { return counts(fault); });
    if (!causes.empty()) return causes;
  }
  return {};
}

std::optional<FirstFault> first_fault(const RunFacts& facts) {
  std::optional<FirstFault> first;
  const auto consider = [&first](const FirstFault& fault) {
    if (!first || fault.where.at < first->where.at) first = fault;
  };
  for (const FaultEvent& fault : facts.faults) {
    if (fault.cause == FaultCause::kDrivesOff) continue;
    consider({.what = FirstFault::What::kReported, .cause = fault.cause, .where = fault.where});
  }
  for (const BusAbortEvent& abort : facts.bus_aborts) {
    consider({.what = FirstFault::What::kBusError, .where = abort.where});
  }
  // The logic itself takes the servo power away before the controller reports it.
  if (!first && facts.controller_silent && facts.servo_off_at) {
    consider({.what = FirstFault::What::kServoOff, .where = *facts.servo_off_at});
  }
  return first;
}

}  // namespace armature::cosim
