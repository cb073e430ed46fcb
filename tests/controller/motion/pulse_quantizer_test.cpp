#include "controller/motion/pulse_quantizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/robot/axis_units.hpp"
#include "controller/trajectory/profile/trapezoid.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/controller/support/reference_data.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature {
namespace {

constexpr Pulses kMax{kMaxPulsesPerTick};

// CRC-32 of zlib over little-endian 16-bit values.
std::uint32_t crc32_int16le(const std::vector<std::int64_t>& values) {
  std::uint32_t crc = 0xFFFF'FFFFu;
  for (const std::int64_t value : values) {
    for (int byte = 0; byte < 2; ++byte) {
      crc ^= (static_cast<std::uint32_t>(value) >> (8 * byte)) & 0xFFu;
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB8'8320u : 0u);
    }
  }
  return ~crc;
}

// Joint angle at the end of period k of a pulse sequence.
class Path {
 public:
  explicit Path(const nlohmann::json& sequence) {
    const double duration_s = sequence["N"].get<double>() * kTickSeconds;
    if (sequence.contains("profile")) {
      const auto& json = sequence["profile"];
      const double q = json["s"].get<double>() * json["q"].get<double>();
      profile_ = json["shape"] == "triangle" ? plan_triangle(q, duration_s) : plan_with_accel(q, json["a"], duration_s);
    } else if (sequence.contains("q")) {
      profile_ = plan_profile(sequence["q"], {.speed = sequence["w"], .accel = sequence["a"]});
    } else {
      creep_deg_s_ = sequence["ideal_pulses"].get<double>() * 7.2e-4 / duration_s;  // slow_creep: constant speed
    }
  }
  double deg(int k) const { return position(profile_, k * kTickSeconds) + creep_deg_s_ * (k * kTickSeconds); }

 private:
  TrapezoidProfile profile_;
  double creep_deg_s_ = 0.0;
};

std::vector<std::int64_t> absolute(const std::vector<std::int64_t>& counts) {
  std::vector<std::int64_t> sums;
  std::int64_t sum = 0;
  for (const std::int64_t n : counts) sums.push_back(sum += n);
  return sums;
}

class PulseSequences : public testing::Test {
 protected:
  const nlohmann::json reference = test::read_reference("pulses.json");
  const AxisUnits units{test::paper_robot().axes[0]};

  std::vector<std::int64_t> quantize(const nlohmann::json& sequence, Pulses max) const {
    const Path path{sequence};
    PulseQuantizer quantizer{max};
    std::vector<std::int64_t> counts;
    for (int k = 1; k <= sequence["N"]; ++k) {
      const Radians joint{path.deg(k) * test::kDeg};
      counts.push_back(quantizer.next(units.to_pulses(joint)).value());
    }
    return counts;
  }
};

TEST_F(PulseSequences, AgreeWithTheReference) {
  ASSERT_EQ(reference["sequences"].size(), 11u);
  for (const auto& sequence : reference["sequences"]) {
    SCOPED_TRACE(sequence["kind"].get<std::string>());
    const auto expected = sequence["n"].get<std::vector<std::int64_t>>();
    ASSERT_EQ(crc32_int16le(expected), sequence["crc32_int16le"].get<std::uint32_t>()) << "damaged reference";
    const auto counts = quantize(sequence, Pulses{1'000});
    const auto sums = absolute(counts);
    const auto expected_sums = absolute(expected);
    ASSERT_EQ(sums.size(), expected_sums.size());
    EXPECT_EQ(sums.back(), sequence["sum"].get<std::int64_t>());
    std::vector<std::int64_t> ties = sequence["tie_periods"];
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const bool tie = std::find(ties.begin(), ties.end(), static_cast<std::int64_t>(k + 1)) != ties.end();
      ASSERT_LE(std::llabs(sums[k] - expected_sums[k]), tie ? 1 : 0) << "period " << k + 1;
    }
    if (ties.empty()) {
      EXPECT_EQ(crc32_int16le(counts), sequence["crc32_int16le"].get<std::uint32_t>());
    }
  }
}

TEST_F(PulseSequences, AboveTheRateLimitTheBacklogIsKept) {
  for (const auto& sequence : reference["sequences"]) {
    if (!sequence.contains("clamped_200")) continue;
    const auto expected = absolute(sequence["clamped_200"].get<std::vector<std::int64_t>>());
    const auto sums = absolute(quantize(sequence, kMax));
    for (std::size_t k = 0; k < sums.size(); ++k) ASSERT_LE(std::llabs(sums[k] - expected[k]), 1) << k;
    EXPECT_EQ(sums.back(), sequence["clamped_sum"].get<std::int64_t>());
    return;
  }
  FAIL() << "no over-rate sequence in the reference";
}

// Why the controller does not do what the paper prints: n = trunc((q_k - q_{k-1}) / resolution), remainder dropped.
TEST_F(PulseSequences, ThePrintedEquation23LosesPulses) {
  int checked = 0;
  for (const auto& sequence : reference["sequences"]) {
    if (!sequence.contains("printed_eq23_sum") || !sequence["tie_periods"].empty()) continue;
    const Path path{sequence};
    std::int64_t printed = 0;
    double last_deg = 0.0;
    for (int k = 1; k <= sequence["N"]; ++k) {
      const double now_deg = path.deg(k);
      printed += static_cast<std::int64_t>((now_deg - last_deg) / 7.2e-4);
      last_deg = now_deg;
    }
    const auto expected = sequence["printed_eq23_sum"].get<std::int64_t>();
    // Differences that are meant to be whole fall on either side in double.
    EXPECT_NEAR(static_cast<double>(printed), static_cast<double>(expected), 0.03 * std::fabs(expected) + 1.0)
        << sequence["kind"];
    if (sequence.contains("profile")) {
      EXPECT_LT(std::llabs(printed), std::llabs(sequence["sum"].get<std::int64_t>())) << sequence["kind"];
      ++checked;
    }
  }
  EXPECT_EQ(checked, 2);
}

TEST(PulseQuantizer, AMillionTicksLoseNoPulse) {
  constexpr std::uint64_t kSeed = 8;
  test::Random random{kSeed};
  const AxisUnits units{test::paper_robot().axes[0]};
  PulseQuantizer quantizer{kMax};
  std::int64_t sum = 0;
  double joint_rad = 0.0;
  double speed_rad = 0.0;  // per tick, up to 60 pulses
  for (int k = 0; k < 1'000'000; ++k) {
    speed_rad = std::fmin(std::fmax(speed_rad + random.real(-1e-5, 1e-5), -7.5e-4), 7.5e-4);
    joint_rad += speed_rad;
    const Pulses count = quantizer.next(units.to_pulses(Radians{joint_rad}));
    ASSERT_LE(std::llabs(count.value()), kMaxPulsesPerTick);
    sum += count.value();
    ASSERT_LE(std::fabs(static_cast<double>(sum) - units.to_exact_pulses(Radians{joint_rad})), 0.5 + 1e-6)
        << "seed " << kSeed << " tick " << k;
  }
  EXPECT_EQ(quantizer.committed().value(), sum);
}

TEST(PulseQuantizer, PulsesThatWereNotEmittedComeAgain) {
  PulseQuantizer quantizer{kMax};
  EXPECT_EQ(quantizer.next(Pulses{100}), Pulses{100});
  quantizer.not_emitted(Pulses{3});
  EXPECT_EQ(quantizer.committed(), Pulses{97});
  EXPECT_EQ(quantizer.next(Pulses{110}), Pulses{13});
}

TEST(PulseQuantizer, ARestartForgetsTheBacklogButNotTheSum) {
  PulseQuantizer quantizer{kMax};
  EXPECT_EQ(quantizer.next(Pulses{1'000}), kMax);
  quantizer.restart(Pulses{200}, Pulses{50});  // 200 were emitted and the axis stands at position 50
  EXPECT_EQ(quantizer.next(Pulses{50}), Pulses{0});
  EXPECT_EQ(quantizer.next(Pulses{45}), Pulses{-5});
  EXPECT_EQ(quantizer.committed(), Pulses{195});
}

TEST(PulseQuantizer, WorksFarFromZero) {
  PulseQuantizer quantizer{kMax};
  quantizer.restart(Pulses{std::int64_t{1} << 40}, Pulses{-(std::int64_t{1} << 41)});
  EXPECT_EQ(quantizer.next(Pulses{-(std::int64_t{1} << 41) + 7}), Pulses{7});
}

}  // namespace
}  // namespace armature
