#include "cosim/report/judge/expect.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "cosim/report/facts/fact.hpp"
#include "cosim/report/facts/value_text.hpp"
#include "cosim/report/judge/comparison.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

class Judge {
 public:
  Judge(const ExpectSpec& expect, const RunFacts& facts) : expect_{expect}, facts_{facts} {}

  // The keys of the scenario that compare this fact.
  void judge_stated(const Fact& fact) {
    for (const Expectation& expectation : fact.expectations) {
      const std::optional<FactValue> wanted = wanted_of(expectation);
      if (!wanted) continue;
      const double tolerance = expectation.tolerance == nullptr ? 0 : expectation.tolerance(expect_);
      ComparedFact result = compare(fact, expectation, *wanted, tolerance, facts_);
      if (expectation.relation == Relation::kWithin) result.expected += tolerance_text(expectation, tolerance);
      results_.push_back({std::string{expectation.key}, result.expected, result.got, result.met, result.margin});
      if (result.met) continue;
      fail(expectation.key, std::move(result));
    }
  }

  // The value that a fact must have if the scenario does not mention the fact.
  void judge_unstated(const Fact& fact) {
    if (!fact.otherwise || mentions(fact)) return;
    if (std::holds_alternative<std::monostate>(fact.value(facts_))) return;  // of a kind of run that this is not
    if (!fact.otherwise->mentioned_by.empty() && mentions(fact_named(fact.otherwise->mentioned_by))) return;
    ComparedFact result = compare(fact, {.key = fact.name}, fact.otherwise->value, 0, facts_);
    if (result.met) return;
    result.expected = fact.otherwise->text;
    fail(fact.name, std::move(result));
  }

  // Faults that were cleared, and drops of the servo enables. `outcome` judges a fault that lasts to the end.
  void judge_unstated_faults() {
    const bool outcome_is_fault = expect_.outcome && *expect_.outcome != kCompleted;
    if (!expect_.faults) {
      std::vector<std::string> unmentioned;
      for (const FaultEvent& fault : facts_.faults) {
        const std::string_view cause = word_of(fault.cause);
        const bool mentioned = cause == expect_.stopped_by ||
                               (outcome_is_fault && cause == cause_of(*expect_.outcome)) ||
                               cause == cause_of(facts_.outcome());
        if (!mentioned) unmentioned.emplace_back(cause);
      }
      if (!unmentioned.empty()) {
        fail("faults",
             {.expected = "only the stated ones", .got = "also " + show_list(unmentioned), .where = at_faults(facts_)});
      }
    }
    const bool stop_is_mentioned =
        expect_.stopped_by || outcome_is_fault || (expect_.faults && !expect_.faults->empty());
    if (!stop_is_mentioned && !facts_.stopped_by.empty()) {
      fail("stopped_by",
           {.expected = "no stop, as it is not stated", .got = facts_.stopped_by, .where = at_faults(facts_)});
    }
  }

  [[nodiscard]] std::vector<ExpectFailure> failures() && { return std::move(failures_); }
  [[nodiscard]] std::vector<ExpectResult> results() && { return std::move(results_); }

 private:
  [[nodiscard]] std::optional<FactValue> wanted_of(const Expectation& expectation) const {
    return expectation.wanted(expect_, facts_.axis_count);
  }

  [[nodiscard]] bool mentions(const Fact& fact) const {
    return std::ranges::any_of(fact.expectations, [&](const Expectation& one) { return wanted_of(one).has_value(); });
  }

  [[nodiscard]] Origin origin_of(std::string_view key) const {
    const auto found = expect_.origins.find(key);
    return found == expect_.origins.end() ? Origin{} : found->second;
  }

  // ` +-0.001`, and the `--set` that the tolerance is from.
  [[nodiscard]] std::string tolerance_text(const Expectation& expectation, double tolerance) const {
    if (expectation.tolerance_key.empty()) return ", each +-50 us";
    const Origin origin = origin_of(expectation.tolerance_key);
    const std::string from = origin.override_text.empty() ? "" : " (" + place_text(expect_.file, origin) + ")";
    return " +-" + number_text(tolerance) + from;
  }

  void fail(std::string_view key, ComparedFact result) {
    failures_.push_back({.key = std::string{key},
                         .expected = std::move(result.expected),
                         .got = std::move(result.got),
                         .where = std::move(result.where),
                         .file = expect_.file,
                         .origin = origin_of(key)});
  }

  const ExpectSpec& expect_;
  const RunFacts& facts_;
  std::vector<ExpectFailure> failures_;
  std::vector<ExpectResult> results_;  // of the stated keys
};

}  // namespace

std::vector<ExpectFailure> check(const ExpectSpec& expect, const RunFacts& facts) {
  Judge judge{expect, facts};
  for (const Fact& fact : fact_list()) judge.judge_stated(fact);
  for (const Fact& fact : fact_list()) judge.judge_unstated(fact);
  judge.judge_unstated_faults();
  return std::move(judge).failures();
}

std::vector<ExpectResult> expect_results(const ExpectSpec& expect, const RunFacts& facts) {
  Judge judge{expect, facts};
  for (const Fact& fact : fact_list()) judge.judge_stated(fact);
  return std::move(judge).results();
}

}  // namespace armature::cosim
