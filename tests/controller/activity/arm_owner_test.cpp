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
  void on_stop(StopKind how) noexcept override {
    notes_.push_back(name_ + (how == StopKind::kHold ? " hold" : how == StopKind::kSoft ? " soft" : " quick"));
  }
  void drop(Refusal) noexcept override { notes_.push_back(name_ + " drop"); }
  void on_rest() noexcept override { notes_.push_back(name_ + " rest"); }

  bool is_idle = true;

 private:
  std::string name_;
  std::vector<std::string>& notes_;
};

class ArmOwnerTest : public testing::Test {
 protected:
  ArmOwnerTest() { bench.owner.set_activities(first, second); }
  void begin() {
    bench.at_rest();
    notes.clear();
  }
  // The next request to core 0, as text; empty: there is none.
  [[nodiscard]] std::string request() {
    const Request* next = bench.channel->requests.front();
    if (next == nullptr) return "";
    using Kind = Request::Kind;
    std::string text = next->kind == Kind::kBegin       ? "begin"
                       : next->kind == Kind::kFeed      ? "feed"
                       : next->kind == Kind::kStop      ? "stop"
                       : next->kind == Kind::kSwitchOff ? "switch off"
                                                        : "clear fault";
    if (next->kind == Kind::kStop) {
      text += next->stop == StopKind::kHold ? " hold" : next->stop == StopKind::kSoft ? " soft" : " quick";
    }
    bench.channel->requests.drop_front();
    return text;
  }

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
  owner.release();
  EXPECT_FALSE(owner.has(ActivityId::kJog));
  EXPECT_FALSE(owner.has(ActivityId::kPlans));
  const PerAxis<Radians> elsewhere = test::degrees({1, 2, 3, 4, 5, 6});
  bench.notify(Answer::Kind::kRest, elsewhere);
  EXPECT_TRUE(owner.has(ActivityId::kPlans));
  EXPECT_EQ(owner.end(), elsewhere);
}

TEST_F(ArmOwnerTest, ARestThatAnswersAnEarlierRequestHasNoEffect) {
  begin();
  owner.begin(ActivityId::kJog, 1);
  bench.at_rest();  // answers the request before
  EXPECT_TRUE(owner.has(ActivityId::kJog));
  EXPECT_THAT(notes, IsEmpty());
  Answer rest = test::OwnerBench::rest_at(test::kReady);
  rest.number = 1;
  owner.on_answer(rest);
  EXPECT_TRUE(owner.has(ActivityId::kPlans));
}

TEST_F(ArmOwnerTest, AStopDropsThenTellsEveryActivityAndStopsPlans) {
  begin();
  (void)owner.accept(Stop{.kind = Stop::Kind::kSoft});
  EXPECT_THAT(notes, ElementsAre("first drop", "second drop", "first soft", "second soft"));
  EXPECT_EQ(request(), "stop soft");
  EXPECT_FALSE(owner.has(ActivityId::kPlans));
}

TEST_F(ArmOwnerTest, AStopIsForTheActivityThatHasTheArm) {
  begin();
  owner.begin(ActivityId::kStream, 1);
  (void)request();
  (void)owner.accept(Stop{});
  ASSERT_NE(bench.channel->requests.front(), nullptr);
  EXPECT_EQ(bench.channel->requests.front()->to, ActivityId::kStream);
  EXPECT_EQ(request(), "stop quick");
}

TEST_F(ArmOwnerTest, OnlyAStrongerStopReplacesTheOneThatBrakes) {
  begin();
  for (const auto kind : {Stop::Kind::kSoft, Stop::Kind::kSoft, Stop::Kind::kQuick, Stop::Kind::kSoft}) {
    (void)owner.accept(Stop{.kind = kind});
  }
  EXPECT_EQ(request(), "stop soft");
  EXPECT_EQ(request(), "stop quick");
  EXPECT_EQ(request(), "");
}

TEST_F(ArmOwnerTest, AHoldEndsABorrowerAndKeepsWhatWaits) {
  begin();
  (void)owner.accept(Hold{});
  EXPECT_THAT(notes, ElementsAre("first hold", "second hold"));
  EXPECT_TRUE(bench.channel->control.view().hold);
  EXPECT_EQ(request(), "");  // plans obey the word
  owner.begin(ActivityId::kHoming, 1);
  (void)request();
  (void)owner.accept(Hold{});
  EXPECT_EQ(request(), "stop hold");
}

TEST_F(ArmOwnerTest, AFaultEndsEverythingAndReleasesTheHold) {
  begin();
  (void)owner.accept(Hold{});
  owner.lend(ActivityId::kHoming);
  notes.clear();
  bench.notify(Answer::Kind::kFault);
  EXPECT_THAT(notes, ElementsAre("first drop", "second drop", "first rest", "second rest"));
  EXPECT_TRUE(owner.in_fault());
  EXPECT_FALSE(bench.channel->control.view().hold);
}

TEST_F(ArmOwnerTest, ClearFaultIsAnOrderOnlyInFaultAndIsRefusedWhereNothingAnswers) {
  begin();
  EXPECT_FALSE(owner.accept(ClearFault{}).has_value());
  EXPECT_EQ(request(), "");
  bench.notify(Answer::Kind::kFault);
  EXPECT_FALSE(owner.accept(ClearFault{.tag = 7}).has_value());
  EXPECT_EQ(request(), "clear fault");
  EXPECT_FALSE(owner.in_fault());  // what comes now waits for the answer
  bench.notify(Answer::Kind::kFaultPersists);
  EXPECT_TRUE(owner.in_fault());
  EXPECT_THAT(bench.refused(Refusal::kNotReady), ElementsAre(7u));
  bench.notify(Answer::Kind::kUnusable);
  EXPECT_TRUE(owner.accept(ClearFault{.tag = 8}).has_value());
}

TEST_F(ArmOwnerTest, UnknownJointAnglesDropWhatWaits) {
  owner.on_answer(test::OwnerBench::rest_at(test::kReady, 0x1F));
  EXPECT_FALSE(owner.referenced());
  EXPECT_THAT(notes, ElementsAre("first rest", "second rest", "first drop", "second drop"));
}

TEST_F(ArmOwnerTest, TheDrivesAreSwitchedOffOnlyAtRest) {
  begin();
  first.is_idle = false;
  EXPECT_TRUE(owner.accept(SwitchOff{}).has_value());
  EXPECT_EQ(request(), "");
  first.is_idle = true;
  EXPECT_FALSE(owner.accept(SwitchOff{}).has_value());
  EXPECT_EQ(request(), "switch off");
}

}  // namespace
}  // namespace armature
