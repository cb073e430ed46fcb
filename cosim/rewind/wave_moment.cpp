#include "cosim/rewind/wave_moment.hpp"

#include <algorithm>
#include <utility>

#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kAfter{kClkFreqHz / 1000};  // 1 ms

bool counts(const MomentWave& wanted, const WaveMoment& moment) {
  return (!wanted.from || moment.to >= *wanted.from) && (!wanted.to || moment.from <= *wanted.to);
}

// The first one.
void add_fault(std::vector<WaveMoment>& moments, const MomentWave& wanted, const RunSummary& summary) {
  for (const FaultEvent& fault : summary.facts.faults) {
    if (fault.cause == FaultCause::kDrivesOff) continue;  // no fault of the arm
    const Cycles at = fault.where.at;
    WaveMoment moment{.what = "the fault " + std::string{word_of(fault.cause)}, .from = at, .to = at};
    if (fault.where.axis != 0) moment.what += " of axis " + std::to_string(fault.where.axis);
    if (!counts(wanted, moment)) continue;
    moments.push_back(std::move(moment));
    return;
  }
}

void add_failures(std::vector<WaveMoment>& moments, const RunSummary& summary) {
  if (summary.failure) moments.push_back({"the failure of the run", summary.facts.cycles, summary.facts.cycles});
  for (const ExpectFailure& failure : summary.expect_failures) {
    if (failure.where.at) moments.push_back({"expect." + failure.key, failure.where.at->at, failure.where.at->at});
  }
}

void add_mismatch(std::vector<WaveMoment>& moments, const RunSummary& summary) {
  const std::optional<TimeSpan>& begins = summary.golden.begins;
  if (!begins) return;
  moments.push_back({"the difference from the golden", to_cycles(begins->from_s), to_cycles(begins->to_s)});
}

}  // namespace

std::vector<WaveMoment> wave_moments(const MomentWave& wanted, const RunSummary& summary) {
  std::vector<WaveMoment> moments;
  switch (wanted.reason) {
    case WaveReason::kFault:
      add_fault(moments, wanted, summary);
      break;
    case WaveReason::kFail:
      add_failures(moments, summary);
      break;
    case WaveReason::kMismatch:
      add_mismatch(moments, summary);
      break;
  }
  std::erase_if(moments, [&](const WaveMoment& moment) { return !counts(wanted, moment); });
  return moments;
}

std::optional<WaveMoment> shown_moment(const MomentWave& wanted, const RunSummary& summary) {
  const std::vector<WaveMoment> moments = wave_moments(wanted, summary);
  if (const auto first = std::ranges::min_element(moments, {}, &WaveMoment::from); first != moments.end()) {
    return *first;
  }
  if (wanted.reason != WaveReason::kFail || summary.expect_failures.empty()) return std::nullopt;
  const Cycles end = summary.facts.cycles;
  WaveMoment moment{"expect." + summary.expect_failures.front().key + ", at the end of the run,", end, end};
  if (!counts(wanted, moment)) return std::nullopt;
  return moment;
}

WaveSpan span_of(const MomentWave& wanted, const WaveMoment& moment) {
  return {.from = std::max(moment.from - wanted.before, Cycles{}), .to = wanted.to.value_or(moment.to + kAfter)};
}

}  // namespace armature::cosim
