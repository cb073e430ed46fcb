// The receiver of axi_uart16550 runs over while a pendant sends a program. The frames that are lost are repeated.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cosim/run/run.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

class PendantSteps final : public RunListener {
 public:
  void on_signal(const Signal& signal, const RunPlace& place) override {
    const auto* step = std::get_if<PendantStepDone>(&signal);
    if (step == nullptr) return;
    texts.push_back(step->text);
    times.push_back(place.at);
  }

  std::vector<std::string> texts;
  std::vector<Cycles> times;
};

constexpr Cycles kUnheard{1'000'000};  // 20 ms, in which 30 frames come

// The pendant switches the drives on and sends a program.
PendantSteps download(bool overrun, Engine engine) {
  Scenario scenario = load_scenario(test::kScenarios / "pendant_program", test::shipped());
  scenario.engine = engine;
  scenario.duration_s = 0.15;
  scenario.pendant->steps.resize(2);
  if (overrun) scenario.faults = {{.at_s = 0.01, .kind = UartOverrun{.duration_s = 0.02}}};
  PendantSteps steps;
  EXPECT_EQ(test::summary_of(scenario, {&steps}).failure, std::nullopt);
  return steps;
}

TEST(UartOverrun, DelaysAProgramWhoseFramesAreRepeated) {
  const PendantSteps calm = download(false, Engine::kModel), late = download(true, Engine::kModel);
  ASSERT_EQ(calm.texts.size(), 2u);
  ASSERT_EQ(late.texts.size(), 2u);
  EXPECT_EQ(late.times[0], calm.times[0]);
  EXPECT_THAT(late.texts[1], testing::HasSubstr(": ok"));
  EXPECT_GE(late.times[1], calm.times[1] + kUnheard);
}

TEST(UartOverrun, IsTheSameOnBothEngines) {
  EXPECT_EQ(download(true, Engine::kLockstep).texts, download(true, Engine::kModel).texts);
}

}  // namespace
}  // namespace armature::cosim
