// What a campaign draws: every kind with every key, within the ranges of the tables, the same on each machine.
#include "cosim/campaign/draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>

#include "cosim/campaign/draw_fault.hpp"
#include "cosim/campaign/draw_moves.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/kinds.hpp"
#include "tests/cosim/support/scenario_files.hpp"

namespace armature::cosim {
namespace {

RobotSpec vo2021() {
  return find_robot("vo2021_6r", test::kScenarios);
}

TEST(CampaignDraw, IsTheSameSequenceForANumber) {
  Draw draw{1, 0, 7}, again{1, 0, 7}, other{1, 0, 8}, stream{1, 1, 7}, seed{2, 0, 7};
  const std::uint64_t first = draw.seed();
  EXPECT_EQ(first, 8'843'956'485'848'410'970u);
  EXPECT_EQ(again.seed(), first);
  EXPECT_NE(other.seed(), first);
  EXPECT_NE(stream.seed(), first);
  EXPECT_NE(seed.seed(), first);
}

TEST(CampaignDraw, DrawsEachDecadeAsOften) {
  Draw draw{3, 0, 0};
  std::map<int, int> decades;
  constexpr int kCount = 3000;
  for (int i = 0; i < kCount; ++i) {
    const double value = draw.decades(2e-5, 0.3);
    ASSERT_GE(value, 2e-5);
    ASSERT_LE(value, 0.3);
    ++decades[static_cast<int>(std::floor(std::log10(value) + 1e-9))];
  }
  for (int decade = -4; decade <= -2; ++decade) EXPECT_NEAR(decades[decade], 0.2 * kCount, 0.04 * kCount) << decade;
}

// Nearly all that is drawn is taken by the loader, which checks each range.
TEST(CampaignDraw, DrawsEveryKindOfFaultWithValuesThatTheLoaderTakes) {
  const RobotSpec robot = vo2021();
  const test::TempFolder folder;
  std::map<std::string_view, int> taken;
  std::map<std::string_view, std::set<std::string>> values;
  int refused = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    Draw draw{5, 1, i};
    CampaignCase drawn{.description = "x", .robot = "vo2021_6r", .duration_s = 1};
    drawn.faults.push_back(draw_fault(draw, robot, draw.number(0, 0.9)));
    try {
      const Scenario scenario = load_case(drawn, folder.path(), test::shipped());
      const FaultKind& kind = scenario.faults.at(0).kind;
      ++taken[fault_kind_name(kind)];
      for (const NamedValue& parameter : fault_parameters(kind)) {
        values[parameter.key].insert(fault_text(scenario.faults.at(0)));
      }
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_LT(refused, 30);
  for (const std::string_view name : fault_kind_names()) EXPECT_GT(taken[name], 3) << name;
  for (const auto& [key, texts] : values) EXPECT_GT(texts.size(), 1u) << key;
}

TEST(CampaignDraw, DrawsOnlyTheKindsThatItIsGiven) {
  const std::vector<std::string> names{"pulse_loss", "estop"};
  std::map<std::string, int> drawn;
  for (std::uint64_t i = 0; i < 100; ++i) {
    Draw draw{5, 1, i};
    const std::string text = draw_fault(draw, vo2021(), 0.5, names);
    const std::size_t begin = text.find('"') + 1;
    ++drawn[text.substr(begin, text.find('"', begin) - begin)];
  }
  EXPECT_EQ(drawn.size(), 2u);
  for (const std::string& name : names) EXPECT_GT(drawn[name], 30) << name;
}

TEST(CampaignDraw, KnowsAllKinds) {
  std::size_t count = 0;
  for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
    if (FaultInside<Kind>) return;
    EXPECT_EQ(fault_kind_names().at(count++), fault_kind_name(Kind{}));
  });
  EXPECT_EQ(fault_kind_names().size(), count);
}

// The last step turns every motor twice and a bit, within the range of its axis.
TEST(CampaignDraw, EndsWithTwoTurnsOfEachMotorWithinTheRange) {
  const RobotSpec robot = vo2021();
  for (std::uint64_t i = 0; i < 50; ++i) {
    Draw draw{9, 0, i};
    const DrawnMoves moves = draw_moves(draw, {robot});
    ASSERT_GE(moves.drawn.steps.size(), kFirstSteps + 1 + kLastSteps);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_GT(moves.end_deg[axis], robot.axes[axis].min_deg);
      EXPECT_LT(moves.end_deg[axis], robot.axes[axis].max_deg);
    }
    const test::TempFolder folder;
    EXPECT_NO_THROW((void)load_case(
        [&] {
          CampaignCase drawn = moves.drawn;
          drawn.duration_s = 1;
          return drawn;
        }(),
        folder.path(), test::shipped()));
  }
}

}  // namespace
}  // namespace armature::cosim
