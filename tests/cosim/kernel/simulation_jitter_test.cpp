// Shipped scenarios, cut short, with input jitter.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

const std::filesystem::path kScenarios = ARMATURE_SOURCE_DIR "/scenarios";

class Faults final : public test::SilentListener {
 public:
  void on_event(const Event& event, Cycles) override {
    if (const auto* fault = std::get_if<Faulted>(&event)) causes.push_back(fault->cause);
  }
  std::vector<FaultCause> causes;
};

struct Ending {
  EndReason reason{};
  std::string failure;
  std::vector<FaultCause> faults;
};

Ending ending(const Scenario& scenario) {
  Faults faults;
  const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), faults});
  return {end.reason, end.failure, faults.causes};
}

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{kScenarios}) {
    if (std::filesystem::exists(entry.path() / "scenario.toml")) names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The checker of conservation runs in each of them. A violation would be their failure.
TEST(SimulationJitter, ShippedScenariosEndAsTheyDoWithoutIt) {
  constexpr double kLongest_s = 0.08;
  const std::vector<std::string> names = shipped();
  ASSERT_GT(names.size(), 50u);
  std::uint64_t seed = 1;
  for (const std::string& name : armature::test::cases(names)) {
    Scenario scenario = load_scenario(kScenarios / name, {.search_path = kScenarios, .overrides = {}});
    scenario.duration_s = std::min(scenario.duration_s, kLongest_s);
    scenario.seed = seed++;
    scenario.engine = Engine::kModel;
    const Ending exact = ending(scenario);
    scenario.input_jitter = true;
    const Ending jittery = ending(scenario);
    EXPECT_EQ(jittery.reason, exact.reason) << name << ", seed " << scenario.seed << ": " << jittery.failure;
    EXPECT_EQ(jittery.failure, exact.failure) << name << ", seed " << scenario.seed;
    EXPECT_EQ(jittery.faults, exact.faults) << name << ", seed " << scenario.seed;
  }
}

}  // namespace
}  // namespace armature::cosim
