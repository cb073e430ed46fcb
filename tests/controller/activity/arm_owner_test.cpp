#include "controller/activity/arm_owner.hpp"

#include <gmock/gmock.h>

#include <optional>
#include <string>
#include <vector>

#include "tests/controller/activity/owner_bench.hpp"

namespace armature {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Notes what it is asked.
class Noted final : public Activity {
 public:
  Noted(std::string name, std::vector<std::string>& notes) : name_{std::move(name)}, notes_{notes} {}

  [[nodiscard]] bool idle() const noexcept override { return is_idle; }
  void stop(StopKind how) noexcept override {
    notes_.push_back(name_ + (how == StopKind::kHold ? " hold" : how == StopKind::kSoft ? " soft" : " quick"));
  }
  void drop(Refusal) noexcept override { notes_.push_back(name_ + " drop"); }
  void on_rest() noexcept override { notes_.push_back(name_ + " rest"); }
  [[nodiscard]] bool answered_by(const MotionNotice& notice) const noexcept override { return notice.jogs == sent; }

  bool is_idle = true;
  std::uint32_t sent = 0;

 private:
  std::string name_;
  std::vector<std::string>& notes_;
};

class ArmOwnerTest : public testing::Test {
 protected:
  ArmOwnerTest() {
    bench.owner.set_activities(first, second);
  }
  void begin() {
    bench.at_rest();
    notes.clear();
  }
  [[nodiscard]] std::optional<MotionOrder> order() { return bench.mailbox->orders.try_pop(); }

  test::OwnerBench bench;
  ArmOwner& owner = bench.owner;
  std::vector<std::string> notes;
  Noted first{"first", notes}, second{"second", notes};
};

TEST_F(ArmOwnerTest, PlansHaveTheArmFromTheFirstRestOn) {
  EXPECT_FALSE(owner.has(ActivityId::kPlans));
  EXPECT_EQ(owner.rest(), std::nullopt);
  begin();
  EXPECT_TRUE(owner.has(ActivityId::kPlans));
  EXPECT_EQ(owner.rest(), std::optional{test::kReady});
}

TEST_F(ArmOwnerTest, AnActivityThatWorksOrAHoldMeansNoRest) {
  begin();
  second.is_idle = false;
  EXPECT_EQ(owner.rest(), std::nullopt);
  second.is_idle = true;
  (void)owner.accept(Hold{});
  EXPECT_EQ(owner.rest(), std::nullopt);
  (void)owner.accept(Resume{});
  EXPECT_TRUE(owner.rest().has_value());
}

TEST_F(ArmOwnerTest, LendsTheArmUntilItStands) {
  begin();
  owner.lend(ActivityId::kJog);
  EXPECT_TRUE(owner.has(ActivityId::kJog));
  EXPECT_FALSE(owner.has(ActivityId::kPlans));
  owner.await_rest();
  EXPECT_FALSE(owner.has(ActivityId::kJog));
  EXPECT_FALSE(owner.has(ActivityId::kPlans));
  const PerAxis<Radians> elsewhere = test::degrees({1, 2, 3, 4, 5, 6});
  bench.notify(MotionNotice::Kind::kAtRest, elsewhere);
  EXPECT_TRUE(owner.has(ActivityId::kPlans));
  EXPECT_EQ(owner.end(), elsewhere);
}

TEST_F(ArmOwnerTest, ARestThatAnswersAnEarlierRequestHasNoEffect) {
  begin();
  owner.lend(ActivityId::kJog);
  second.sent = 1;
  bench.at_rest();
  EXPECT_TRUE(owner.has(ActivityId::kJog));
  EXPECT_THAT(notes, IsEmpty());
}

TEST_F(ArmOwnerTest, AStopDropsThenEndsEveryActivityAndOrdersPlansToStop) {
  begin();
  (void)owner.accept(Stop{.kind = Stop::Kind::kSoft});
  EXPECT_THAT(notes, ElementsAre("first drop", "second drop", "first soft", "second soft"));
  EXPECT_EQ(order(), MotionOrder::kStop);
  EXPECT_TRUE(bench.mailbox->control.view().soft_stop);
  EXPECT_FALSE(owner.has(ActivityId::kPlans));
}

TEST_F(ArmOwnerTest, AStopOfABorrowerOrdersNothing) {
  begin();
  owner.lend(ActivityId::kStream);
  (void)owner.accept(Stop{});
  EXPECT_THAT(notes, ElementsAre("first drop", "second drop", "first quick", "second quick"));
  EXPECT_EQ(order(), std::nullopt);
}

TEST_F(ArmOwnerTest, ASoftStopDoesNotWeakenAQuickOneThatBrakes) {
  begin();
  (void)owner.accept(Stop{.kind = Stop::Kind::kQuick});
  (void)owner.accept(Stop{.kind = Stop::Kind::kSoft});
  EXPECT_FALSE(bench.mailbox->control.view().soft_stop);
}

TEST_F(ArmOwnerTest, AHoldEndsABorrowerAndKeepsWhatWaits) {
  begin();
  (void)owner.accept(Hold{});
  EXPECT_THAT(notes, ElementsAre("first hold", "second hold"));
  EXPECT_TRUE(bench.mailbox->control.view().hold);
}

TEST_F(ArmOwnerTest, AFaultEndsEverythingAndReleasesTheHold) {
  begin();
  (void)owner.accept(Hold{});
  owner.lend(ActivityId::kHoming);
  notes.clear();
  bench.notify(MotionNotice::Kind::kFault);
  EXPECT_THAT(notes, ElementsAre("first drop", "second drop", "first rest", "second rest"));
  EXPECT_TRUE(owner.in_fault());
  EXPECT_FALSE(bench.mailbox->control.view().hold);
}

TEST_F(ArmOwnerTest, ClearFaultIsAnOrderOnlyInFaultAndIsRefusedWhereNothingAnswers) {
  begin();
  EXPECT_FALSE(owner.accept(ClearFault{}).has_value());
  EXPECT_EQ(order(), std::nullopt);
  bench.notify(MotionNotice::Kind::kFault);
  EXPECT_FALSE(owner.accept(ClearFault{.tag = 7}).has_value());
  EXPECT_EQ(order(), MotionOrder::kClearFault);
  EXPECT_FALSE(owner.in_fault());  // what comes now waits for the answer
  bench.notify(MotionNotice::Kind::kFaultPersists);
  EXPECT_TRUE(owner.in_fault());
  EXPECT_THAT(bench.refused(Refusal::kNotReady), ElementsAre(7u));
  bench.notify(MotionNotice::Kind::kUnusable);
  EXPECT_TRUE(owner.accept(ClearFault{.tag = 8}).has_value());
}

TEST_F(ArmOwnerTest, UnknownJointAnglesDropWhatWaits) {
  owner.on_notice(test::OwnerBench::rest_at(test::kReady, 0x1F));
  EXPECT_FALSE(owner.referenced());
  EXPECT_THAT(notes, ElementsAre("first rest", "second rest", "first drop", "second drop"));
}

TEST_F(ArmOwnerTest, TheDrivesAreSwitchedOffOnlyAtRest) {
  begin();
  first.is_idle = false;
  EXPECT_TRUE(owner.accept(SwitchOff{}).has_value());
  EXPECT_EQ(order(), std::nullopt);
  first.is_idle = true;
  EXPECT_FALSE(owner.accept(SwitchOff{}).has_value());
  EXPECT_EQ(order(), MotionOrder::kSwitchOff);
}

}  // namespace
}  // namespace armature
