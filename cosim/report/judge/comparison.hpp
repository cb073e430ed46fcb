// The comparison of one measured value with the expected one.
#pragma once

#include <optional>
#include <string>

#include "cosim/report/facts/fact.hpp"

namespace armature::cosim {

struct ComparedFact {
  bool met = false;
  std::string expected;  // in words; without the text about a tolerance
  std::string got;
  FactWhere where{};               // empty when met
  std::optional<double> margin{};  // from the value to the limit or the end of the tolerance; negative when not met
};

// `tolerance`: of Relation::kWithin, in the unit of the fact. Values whose types cannot be compared do not meet the
// expectation.
[[nodiscard]] ComparedFact compare(const Fact& fact, const Expectation& expectation, const FactValue& wanted,
                                   double tolerance, const RunFacts& facts);

}  // namespace armature::cosim
