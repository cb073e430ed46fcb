// The number of random draws of a test.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace armature::test {

// Whether the environment variable ARMATURE_FEW_DRAWS is set. tools/test sets it. tools/test --all sets it only with
// sanitizers, which take fifteen times as long; there the other draws would only run the same code again.
[[nodiscard]] inline bool few_draws() {
  static const bool few = std::getenv("ARMATURE_FEW_DRAWS") != nullptr;
  return few;
}

// `all`, or a tenth of them.
[[nodiscard]] inline int draws(int all) {
  return few_draws() ? (all + 9) / 10 : all;
}

// How often at least something occurs in the draws: `all` in all of them; in a tenth, which scatters, a third of it.
[[nodiscard]] inline int least(int all) {
  return few_draws() ? all / 30 : all;
}

// The cases of a test, or with few draws every third of them.
template <typename Cases>
[[nodiscard]] std::vector<typename Cases::value_type> cases(const Cases& all) {
  std::vector<typename Cases::value_type> chosen;
  for (std::size_t i = 0; i < all.size(); i += few_draws() ? 3 : 1) chosen.push_back(all[i]);
  return chosen;
}

}  // namespace armature::test
