#include "controller/base/halving.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

constexpr int kHalvings = 40;

template <class Value>
SignChange bisected(SignChange ends, Value value) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (ends.inside + ends.outside);
    (value(middle) <= 0.0 ? ends.inside : ends.outside) = middle;
  }
  return ends;
}

template <class Value>
int evaluations_of_equal_result(SignChange ends, Value value) {
  int count = 0;
  const SignChange found =
      halved<kHalvings>(ends, {.inside = value(ends.inside), .outside = value(ends.outside)}, [&](double x) {
        ++count;
        return value(x);
      });
  const SignChange wanted = bisected(ends, value);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found.inside), std::bit_cast<std::uint64_t>(wanted.inside));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found.outside), std::bit_cast<std::uint64_t>(wanted.outside));
  return count;
}

TEST(Halving, HasTheBitsOfABisectionInAThirdOfTheEvaluations) {
  test::Random random{61};
  int functions = 0, evaluations = 0;
  for (int round = 0; round < 3000; ++round) {
    const double from = random.real(-3.0, 3.0), way = random.real(0.01, 2.0) * (round % 2 == 0 ? 1.0 : -1.0);
    const double place = random.real(0.0, 1.0), bend = random.real(-0.9, 3.0);
    // The length of a vector that is a quadratic function, as for the rate of a path.
    const auto value = [&](double x) {
      const double share = (x - from) / way, y = share + bend * share * share;
      return std::hypot(y, 0.3) - std::hypot(place + bend * place * place, 0.3);
    };
    if (!(value(from) <= 0.0 && value(from + way) > 0.0)) continue;
    evaluations += evaluations_of_equal_result({.inside = from, .outside = from + way}, value);
    ++functions;
  }
  EXPECT_GT(functions, 1000);
  EXPECT_LT(evaluations, 12 * functions);
}

TEST(Halving, FindsAKinkAJumpAndAChangeAtAnEnd) {
  evaluations_of_equal_result({.inside = 0.0, .outside = 1.0}, [](double x) { return x < 0.3 ? -1e-9 : 1e9 * x; });
  evaluations_of_equal_result({.inside = 0.0, .outside = 1.0}, [](double x) { return x - 1e-14; });
  evaluations_of_equal_result({.inside = 1.0, .outside = 0.0}, [](double x) { return 1e-17 - x; });
  evaluations_of_equal_result({.inside = 1.0, .outside = 0.0}, [](double x) { return -1.0 - x; });
}

}  // namespace
}  // namespace armature
