// The number of random draws of a test.
#pragma once

namespace armature::test {

// `all`, or a tenth of them under sanitizers, which take fifteen times as long. They look for undefined behaviour, and
// the other draws run through the same code again. The program without sanitizers judges all draws.
[[nodiscard]] constexpr int draws(int all) {
#ifdef ARMATURE_FEW_DRAWS
  return (all + 9) / 10;
#else
  return all;
#endif
}

}  // namespace armature::test
