// Outputs at places of a chain that is planned in windows, through the whole controller.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "tests/controller/support/output_edges.hpp"
#include "tests/controller/support/random.hpp"

namespace armature {
namespace {

using Eigen::Vector3d;
using test::Edge;
using test::kThere;
using From = PathOutput::From;
using Unit = PathOutput::Unit;

constexpr double kLine_mm = 0.8;

class WindowOutputsTest : public test::OutputEdgesTest {
 protected:
  // A line of the chain: along y of the tool.
  [[nodiscard]] CartesianMove next_line() const {
    CartesianMove move = shift(0.0, kLine_mm, 0.0, 0.1);
    move.tag = Tag{Source::kProgram, static_cast<std::uint32_t>(lines.size() + 1)};
    return move;
  }
  // On the next line, which is added by add_line(): the other level of this pin at a way from its start.
  void toggle(CartesianMove& move, int pin, From from, double way_mm) {
    bool& level = levels_.at(static_cast<std::size_t>(pin));
    level = !level;
    add(move, pin, level, from, Unit::kMm, from == From::kStart ? way_mm : way_mm - kLine_mm);
    places.push_back({pin, at(0.0, static_cast<double>(lines.size()) * kLine_mm + way_mm)});
  }
  void add_line(const CartesianMove& move) { lines.push_back(move); }

  // Gives the lines to the controller as fast as it accepts them.
  void run(std::int64_t triggers) {
    std::size_t fed = 0;
    rig.on_each_trigger = [&] {
      if (rig.logic.triggers() < kThere) return;
      while (fed < lines.size() && rig.submit_program(lines[fed])) ++fed;
    };
    watch(triggers);
    ASSERT_TRUE(rig.refusals.empty());
    ASSERT_EQ(rig.finished.size(), lines.size() + 1);
  }
  // The arm begins from rest only with the lines that have these numbers, from 1.
  void expect_begins(const std::set<std::size_t>& numbers) const {
    for (std::size_t i = 1; i < rig.moves.size(); ++i) {
      EXPECT_EQ(rig.moves[i].continues, !numbers.contains(i)) << "move " << i;
    }
  }
  // Each of `places` has one edge, in this order for each pin.
  void expect_edges() const {
    ASSERT_EQ(edges.size(), places.size());
    ASSERT_EQ(rig.switched.size(), places.size());
    std::array<std::size_t, 17> next{};
    for (const Edge& edge : edges) {
      std::size_t& i = next.at(static_cast<std::size_t>(edge.pin));
      while (i < places.size() && places[i].pin != edge.pin) ++i;
      ASSERT_LT(i, places.size()) << "pin " << edge.pin;
      expect_edge_at(edge, places[i++].base_mm, test::kGentle.speed_mm_s);
    }
  }

  struct Place {
    int pin;
    Vector3d base_mm;
  };
  std::vector<Place> places;
  std::vector<CartesianMove> lines;

 private:
  std::array<bool, 17> levels_{};
};

TEST_F(WindowOutputsTest, SwitchOnceAtTheirPlacesWithoutAStopAtAnyRate) {
  test::Random random{20261123};
  for (int i = 0; i < 70; ++i) {
    CartesianMove move = next_line();
    if (i % 3 == 0) toggle(move, 1, From::kStart, random.real(0.0, 0.4 * kLine_mm));
    if (i % 5 == 0) toggle(move, 2, From::kStart, 0.0);
    if (i % 7 == 0) toggle(move, 3, From::kEnd, random.real(0.5 * kLine_mm, kLine_mm));
    if (i % 4 == 0) toggle(move, 4, From::kEnd, kLine_mm);
    add_line(move);
  }
  for (int i = 1; i < 15; ++i) rig.submit_at(kThere + 1'000 * i, SetOverride{.share = random.real(0.4, 1.0)});
  run(35'000);
  expect_begins({1});
  expect_edges();
}

TEST_F(WindowOutputsTest, MoreThanAWindowCanHaveMakeItShorter) {
  for (int i = 0; i < 50; ++i) {
    CartesianMove move = next_line();
    for (int pin = 1; pin <= 4; ++pin) toggle(move, pin, From::kStart, 0.2 * pin * kLine_mm);
    add_line(move);
  }
  run(25'000);
  expect_begins({1});
  expect_edges();
}

TEST_F(WindowOutputsTest, OneInTimeMakesTheArmStopBeforeItsMove) {
  constexpr std::size_t kNumber = 30;
  for (std::size_t i = 1; i <= 50; ++i) {
    CartesianMove move = next_line();
    if (i == kNumber) add(move, 1, true, From::kStart, Unit::kSeconds, 0.004);
    add_line(move);
  }
  run(25'000);
  // A plan from rest with such an output is not continued.
  expect_begins({1, kNumber, kNumber + CartesianPlan::kMaxFirstSegments});
  ASSERT_EQ(edges.size(), 1u);
  // The set-point of the move's first tick is reached at the end of the tick after it.
  EXPECT_EQ(edges[0].trigger, rig.moves[kNumber].start_tick.value() + 1 + 80);
}

}  // namespace
}  // namespace armature
