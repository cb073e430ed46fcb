#include "cosim/trace/integer_digest.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/cosim/support/counted_row.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

TraceRow hashed_row(std::int64_t tick) {
  TraceRow row = test::counted_row(tick);
  row.cycle = 3108 + 2500 * tick;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const auto n = static_cast<std::int64_t>(i + 1);
    row.first_rise[i] = row.cycle - 2400 + n;
    row.turned[i] = i == 2 ? row.cycle - 2474 : 0;
    row.motor_from[i] = -tick * n * 16'777'216 + n;
    row.motor_to[i] = row.motor_from[i] - 1'000'000 * n;
  }
  return row;
}

std::string digest_of(std::int64_t ticks) {
  IntegerDigest digest;
  for (std::int64_t tick = 0; tick < ticks; ++tick) digest.add(hashed_row(tick));
  return digest.hex();
}

// Computed in another language from the description of tick_hash().
TEST(IntegerDigest, IsWhatItsDescriptionGivesWhateverItsLength) {
  EXPECT_EQ(digest_of(0), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(digest_of(1), "337f89064de49226111c7f4acc3ecbbecefd5dfe7cd3f4f088f41e677e73af65");
  EXPECT_EQ(digest_of(37), "033091f1152f31f4ec5f1cd82cb980ec89482b18673e5c6af330b5940c882004");
  EXPECT_EQ(digest_of(5000), "ee4178b73f463aa3dff6420f957c33e4edd969d255168e7d5ece78a0e2b276d3");
}

TEST(IntegerDigest, OfARowPinsEveryTickUpToIt) {
  IntegerDigest all, asked_seldom;
  for (std::int64_t tick = 0; tick < 3000; ++tick) {
    all.add(hashed_row(tick));
    asked_seldom.add(hashed_row(tick));
    if (tick % 7 == 0) {
      ASSERT_EQ(all.prefix(), all.hex().substr(0, IntegerDigest::kPrefixDigits));
    }
    if (tick % 1100 == 0) {
      ASSERT_EQ(all.hex(), asked_seldom.hex()) << tick;
      ASSERT_EQ(all.hex(), digest_of(tick + 1)) << tick;
    }
  }
}

// All that the digest covers, as functions that change it by one.
std::vector<std::function<void(TraceRow&)>> changes() {
  std::vector<std::function<void(TraceRow&)>> all{
      [](TraceRow& row) { ++row.tick; },
      [](TraceRow& row) { ++row.cycle; },
      [](TraceRow& row) { row.telemetry.state = MotionState::kFault; },
  };
  for (std::size_t i = 0; i < kAxes; ++i) {
    all.emplace_back([i](TraceRow& row) { row.telemetry.commanded[i] += Pulses{1}; });
    all.emplace_back([i](TraceRow& row) { row.telemetry.encoder[i] += Counts{1}; });
    all.emplace_back([i](TraceRow& row) { row.telemetry.correction[i] += Pulses{1}; });
    for (auto values : {&TraceRow::pin_pulses, &TraceRow::first_rise, &TraceRow::turned, &TraceRow::motor_from,
                        &TraceRow::motor_to}) {
      all.emplace_back([i, values](TraceRow& row) { ++(row.*values)[i]; });
    }
  }
  return all;
}

TEST(IntegerDigest, SeesEveryIntegerOfATickAndNoFloat) {
  std::set<std::uint64_t> hashes{tick_hash(hashed_row(7))};
  for (const auto& change : changes()) {
    TraceRow row = hashed_row(7);
    change(row);
    EXPECT_TRUE(hashes.insert(tick_hash(row)).second) << hashes.size();
  }
  EXPECT_EQ(hashes.size(), 1 + 3 + 8 * kAxes);
  TraceRow row = hashed_row(7);
  row.telemetry.reference[3] = Radians{2.0};
  row.telemetry.actual[3] = Radians{2.0};
  EXPECT_EQ(tick_hash(row), tick_hash(hashed_row(7)));
}

TEST(IntegerDigest, SeesThatValuesAreExchanged) {
  const TraceRow base = hashed_row(7);
  std::set<std::uint64_t> hashes{tick_hash(base)};
  TraceRow row = base;
  std::swap(row.pin_pulses[1], row.pin_pulses[4]);
  hashes.insert(tick_hash(row));
  row = base;
  std::swap(row.first_rise[1], row.turned[1]);
  hashes.insert(tick_hash(row));
  row = base;
  std::swap(row.motor_from[1], row.motor_to[1]);
  hashes.insert(tick_hash(row));
  row = base;
  for (auto values :
       {&TraceRow::pin_pulses, &TraceRow::first_rise, &TraceRow::turned, &TraceRow::motor_from, &TraceRow::motor_to}) {
    std::swap((row.*values)[1], (row.*values)[4]);
  }
  std::swap(row.telemetry.commanded[1], row.telemetry.commanded[4]);
  std::swap(row.telemetry.encoder[1], row.telemetry.encoder[4]);
  std::swap(row.telemetry.correction[1], row.telemetry.correction[4]);
  hashes.insert(tick_hash(row));
  EXPECT_EQ(hashes.size(), 5u);
}

// Small changes of several values at once, as a defect makes them.
TEST(IntegerDigest, DiffersForRandomRowsThatAreAlike) {
  armature::test::SplitMix random{5};
  std::set<std::string> rows;
  std::set<std::uint64_t> hashes;
  const auto all = changes();
  for (int i = 0; i < 20'000; ++i) {
    std::string made(all.size(), '0');
    TraceRow row = hashed_row(7);
    for (int n = 0; n < 4; ++n) {
      const std::size_t which = random.below(static_cast<std::uint32_t>(all.size()));
      if (which == 2 && made[2] != '0') continue;
      all[which](row);
      ++made[which];
    }
    rows.insert(made);
    hashes.insert(tick_hash(row));
  }
  EXPECT_EQ(hashes.size(), rows.size());
}

}  // namespace
}  // namespace armature::cosim
