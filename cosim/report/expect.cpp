#include "cosim/report/expect.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

std::string show(double value) {
  return number_text(std::round(value * 1e6) / 1e6);
}
std::string show(std::int64_t value) {
  return std::to_string(value);
}
std::string show(std::string_view value) {
  return std::string{value};
}

template <class Values>
std::string show_list(const Values& values) {
  std::string text = "[";
  for (const auto& value : values) {
    if (text.size() > 1) text += ", ";
    text += show(value);
  }
  return text += "]";
}

class Checker {
 public:
  void require(bool met, std::string_view key, std::string expected, std::string got) {
    if (!met) failures_.push_back({std::string{key}, std::move(expected), std::move(got)});
  }

  template <class T>
  void exactly(std::string_view key, const std::optional<T>& expected, const T& got) {
    if (expected) require(*expected == got, key, show(*expected), show(got));
  }

  template <class Values>
  void list_exactly(std::string_view key, const std::optional<Values>& expected, const Values& got) {
    if (expected) require(*expected == got, key, show_list(*expected), show_list(got));
  }

  void list_near(std::string_view key, const std::optional<PerAxis<double>>& expected, double tolerance,
                 const PerAxis<double>& got) {
    if (!expected) return;
    const bool met = std::equal(got.begin(), got.end(), expected->begin(),
                                [&](double a, double b) { return std::fabs(a - b) <= tolerance; });
    require(met, key, show_list(*expected) + " +-" + number_text(tolerance), show_list(got));
  }

  void at_least(std::string_view key, std::optional<std::int64_t> expected, std::int64_t got) {
    if (expected) require(got >= *expected, key, "at least " + show(*expected), show(got));
  }

  void at_most(std::string_view key, std::optional<std::int64_t> expected, std::int64_t got) {
    if (expected) require(got <= *expected, key, "at most " + show(*expected), show(got));
  }

  [[nodiscard]] std::vector<ExpectFailure> take() { return std::move(failures_); }

 private:
  std::vector<ExpectFailure> failures_;
};

std::vector<std::int64_t> durations(const RunFacts& facts) {
  std::vector<std::int64_t> ticks;
  for (const MoveReport& move : facts.moves) ticks.push_back(move.duration.value());
  return ticks;
}

std::vector<std::string> first_shapes(const RunFacts& facts) {
  std::vector<std::string> shapes;
  if (facts.moves.empty()) return shapes;
  for (const ProfileShape shape : facts.moves.front().shape) shapes.emplace_back(shape_name(shape));
  return shapes;
}

std::vector<std::string> causes(const RunFacts& facts) {
  std::vector<std::string> names;
  for (const FaultEvent& fault : facts.faults) names.emplace_back(fault_name(fault.cause));
  return names;
}

std::string settle_text(const RunFacts& facts, std::int64_t counts) {
  if (facts.settle_s) return "after " + number_text(*facts.settle_s) + " s";
  return "never within " + std::to_string(counts) + " counts, at the end " + show_list(facts.final_error_counts);
}

// Faults that were cleared again, and servo enables that dropped. A fault at the end is judged by `outcome`.
void check_unmentioned_faults(Checker& checker, const ExpectSpec& expect, const RunFacts& facts) {
  const bool outcome_is_fault = expect.outcome && *expect.outcome != kCompleted;
  if (!expect.faults) {
    std::vector<std::string> unmentioned = causes(facts);
    std::erase_if(unmentioned, [&](const std::string& cause) {
      return cause == expect.stopped_by || (outcome_is_fault && cause == cause_of(*expect.outcome)) ||
             cause == cause_of(facts.outcome());
    });
    checker.require(unmentioned.empty(), "faults", "none but those stated", "also " + show_list(unmentioned));
  }
  const bool stop_is_mentioned = expect.stopped_by || outcome_is_fault || (expect.faults && !expect.faults->empty());
  if (!stop_is_mentioned) {
    checker.require(facts.stopped_by.empty(), "stopped_by", "no stop, as it is not stated", facts.stopped_by);
  }
}

void check_unmentioned(Checker& checker, const ExpectSpec& expect, const RunFacts& facts) {
  if (!expect.outcome) {
    checker.require(facts.outcome() == kCompleted, "outcome", show(kCompleted), show(facts.outcome()));
  }
  if (!expect.refused_moves) {
    std::string reasons;
    for (const RefusedMove& refused : facts.refusals) {
      reasons.append(reasons.empty() ? ": " : ", ").append(refusal_name(refused.refusal.reason));
    }
    checker.require(facts.refusals.empty(), "refused_moves", "0, as it is not stated",
                    std::to_string(facts.refusals.size()) + reasons);
  }
  if (!expect.underruns && !expect.min_underruns) {
    checker.require(facts.underruns == 0, "underruns", "0, as it is not stated", show(facts.underruns));
  }
  check_unmentioned_faults(checker, expect, facts);
}

}  // namespace

std::string ExpectFailure::text() const {
  return "expect." + key + ": expected " + expected + ", got " + got;
}

std::vector<ExpectFailure> check(const ExpectSpec& expect, const RunFacts& facts) {
  Checker checker;
  checker.exactly("outcome", expect.outcome, std::string{facts.outcome()});
  checker.list_near("final_joint_deg", expect.final_joint_deg, expect.tolerance_deg, facts.final_joint_deg);
  checker.list_exactly("total_pulses", expect.total_pulses, facts.total_pulses);
  checker.list_exactly("final_error_counts", expect.final_error_counts, facts.final_error_counts);
  checker.list_exactly("move_ticks", expect.move_ticks, durations(facts));
  checker.list_exactly("profile", expect.profile, first_shapes(facts));
  checker.list_near("peak_speed_deg_s", expect.peak_speed_deg_s, expect.peak_tolerance_deg_s, facts.peak_speed_deg_s);
  checker.exactly("peak_pulses_per_tick", expect.peak_pulses_per_tick, facts.peak_pulses_per_tick);
  checker.exactly("underruns", expect.underruns, facts.underruns);
  checker.at_least("min_underruns", expect.min_underruns, facts.underruns);
  checker.exactly("refused_moves", expect.refused_moves, static_cast<std::int64_t>(facts.refusals.size()));
  if (expect.settled_within_s) {
    checker.require(facts.settle_s && *facts.settle_s <= *expect.settled_within_s, "settled_within_s",
                    "at most " + number_text(*expect.settled_within_s) + " s",
                    settle_text(facts, expect.settled_counts));
  }
  checker.at_most("max_overshoot_counts", expect.max_overshoot_counts,
                  *std::max_element(facts.overshoot_counts.begin(), facts.overshoot_counts.end()));
  checker.at_most("max_correction_pulses", expect.max_correction_pulses, facts.max_correction_pulses);
  if (expect.stopped_by) {
    checker.require(*expect.stopped_by == facts.stopped_by, "stopped_by", *expect.stopped_by,
                    facts.stopped_by.empty() ? "no stop" : facts.stopped_by);
  }
  checker.list_exactly("faults", expect.faults, causes(facts));
  check_unmentioned(checker, expect, facts);
  return checker.take();
}

}  // namespace armature::cosim
