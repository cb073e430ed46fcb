// What a run misses of the [expect] of a scenario, as texts.
#pragma once

#include <string>
#include <vector>

#include "cosim/report/judge/expect.hpp"

namespace armature::cosim::test {

// The texts have no file and line.
inline std::vector<std::string> failures(ExpectSpec expect, const RunFacts& facts) {
  expect.file.clear();
  expect.origins.clear();
  std::vector<std::string> texts;
  for (const ExpectFailure& failure : check(expect, facts)) texts.push_back(failure.text());
  return texts;
}

}  // namespace armature::cosim::test
