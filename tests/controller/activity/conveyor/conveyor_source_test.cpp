#include "controller/activity/conveyor/conveyor_source.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <variant>
#include <vector>

#include "tests/controller/support/conveyor_rig.hpp"

namespace armature {
namespace {

class StandingBelt final : public BeltSensor {
 public:
  [[nodiscard]] Sample latest() noexcept override { return {}; }
};

class Refused final : public EventListener {
 public:
  void on_event(const Event& event) noexcept override {
    if (const auto* refusal = std::get_if<MoveRefused>(&event)) list.push_back(*refusal);
  }
  std::vector<MoveRefused> list;
};

class ConveyorSourceTest : public testing::Test {
 protected:
  void put_into_store(std::uint32_t tag, bool first) {
    ConveyorRequest& request = store.request.free_slot();
    dwell = {.duration = Ticks{100}, .is_dwell = true, .tag = Tag{tag}};
    request.plan = Plan{Piece{dwell}};
    request.first = first;
    request.begin_mm = 100.0;  // the belt never brings the part there
    store.request.push_slot();
  }
  void follow_until_stopped() {
    put_into_store(1, true);
    source.begin({}, {}, Ticks{0});
    source.stop(StopKind::kQuick);
    source.advance(Ticks{1}, {});
    ASSERT_EQ(refused.list.size(), 1u);
  }

  const RobotModel robot = test::irb120();
  const Arm arm{robot};
  const ConveyorConfig config = *test::conveyor::with_conveyor().conveyor;
  StandingBelt belt;
  Refused refused;
  const std::unique_ptr<Channel> channel = std::make_unique<Channel>();  // too large for a stack
  PartStore& store = channel->part_store;
  JointPlan dwell;
  ConveyorSource source{robot, arm, {}, config, belt, *channel, refused};
};

TEST_F(ConveyorSourceTest, RefusesWhatComesWhileTheArmLeavesALostPart) {
  follow_until_stopped();
  put_into_store(2, false);
  std::int64_t tick = 2;
  while (!source.over()) source.advance(Ticks{tick++}, {});
  source.observe(Ticks{tick});
  ASSERT_EQ(refused.list.size(), 2u);
  EXPECT_EQ(refused.list[1].tag, Tag{2u});
  EXPECT_EQ(refused.list[1].reason, Refusal::kPartLost);
  EXPECT_EQ(store.over.load(), 2u);
  EXPECT_EQ(channel->plan_store.released.load(), 2u);
  EXPECT_FALSE(store.request.full());
}

TEST_F(ConveyorSourceTest, KeepsTheFirstPathOfAPartUntilItBegins) {
  put_into_store(1, true);
  source.observe(Ticks{0});
  EXPECT_TRUE(refused.list.empty());
  EXPECT_TRUE(store.request.full());
}

}  // namespace
}  // namespace armature
