// A run in lock-step with a model that is broken on purpose, and the waveforms that it leaves.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/engine/lockstep_fabric.hpp"
#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/model/model_fabric.hpp"
#include "cosim/run/engine_waves.hpp"
#include "cosim/waves/wave_compare.hpp"
#include "cosim/waves/wave_reader.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/support/pin_soc.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

// Takes another count than was written: the first one for axis 1 that is not 0.
class WrongCount final : public FabricWrapper {
 public:
  explicit WrongCount(Variant variant) : FabricWrapper{model::make_model_fabric(variant)} {}
  void set_master(const AxiMasterPins& pins) override {
    AxiMasterPins wrong = pins;
    constexpr std::uint32_t kCount1 = regs::soc::kPulseTrainBase + regs::pulse_train::kCountOffset;
    if (pins.awvalid && pins.awaddr == kCount1) of_count_1_ = true;
    if (pins.awvalid && pins.awaddr != kCount1) of_count_1_ = false;
    if (of_count_1_ && pins.wvalid && pins.wdata != 0) ++wrong.wdata;
    inner().set_master(wrong);
  }

 private:
  bool of_count_1_ = false;
};

// The chip with the engine of the scenario; the model is the broken one.
std::unique_ptr<Soc> chip(const Scenario& scenario) {
  auto broken = std::make_unique<WrongCount>(scenario.variant);
  if (scenario.engine == Engine::kModel) return test::pin_soc(std::move(broken), scenario.bus, scenario.seed);
  auto rtl = make_verilated_fabric(scenario.variant);
  if (scenario.engine == Engine::kRtl) return test::pin_soc(std::move(rtl), scenario.bus, scenario.seed);
  return test::pin_soc(in_lockstep(std::move(rtl), std::move(broken)), scenario.bus, scenario.seed);
}

Scenario moving_scenario() {
  Scenario scenario = test::scenario_with(
      "[[move]]\nat_s = 0.003\ntype = \"joint\"\ntarget_deg = [0.05, -0.05, 0.02, 0.02, -0.02, 0.03]\n");
  scenario.duration_s = 0.03;
  scenario.engine = Engine::kLockstep;
  return scenario;
}

SimulationEnd run(const Scenario& scenario, std::unique_ptr<Soc> soc) {
  test::SilentListener silent;
  return test::run_to_end(Simulation{scenario, std::move(soc), silent});
}

class EngineWaves : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_.path() / name; }
  [[nodiscard]] Cycles last_cycle(const char* name) const {
    WaveReader reader{file(name)};
    while (reader.next_ps() && reader.next()) {
    }
    return wave_cycle(reader.now_ps());
  }

  test::TempFolder folder_;
};

TEST_F(EngineWaves, ARunInLockstepEndsInTheCycleInWhichAPinDiffers) {
  const Scenario scenario = moving_scenario();
  const SimulationEnd end = run(scenario, chip(scenario));
  ASSERT_EQ(end.reason, EndReason::kFailed);
  ASSERT_TRUE(end.engines_differ_at);
  EXPECT_EQ(end.failure, "the engines differ at cycle " + std::to_string(end.engines_differ_at->value()) +
                             ": step_o is 0x0 with the RTL and 0x1 with the model");
  const SimulationEnd whole = run(scenario, make_soc(scenario));
  EXPECT_EQ(whole.reason, EndReason::kFinished) << whole.failure;
  EXPECT_EQ(whole.engines_differ_at, std::nullopt);
}

TEST_F(EngineWaves, TheWaveformsOfBothEnginesDifferFirstWhereTheLockstepEnded) {
  const Scenario scenario = moving_scenario();
  const Cycles at = run(scenario, chip(scenario)).engines_differ_at.value();
  write_engine_waves(scenario, at, folder_.path(), {.make_soc = chip});
  const WaveComparison waves = compare_waves(file(kRtlWaveFile), file(kModelWaveFile));
  ASSERT_TRUE(waves.first) << waves.report();
  EXPECT_EQ(wave_cycle(waves.first->at_ps), at);
  EXPECT_EQ(waves.first->signals.front().signal.name, "top.arm_soc.step_o") << waves.report();
  EXPECT_EQ(wave_cycle(waves.from_ps), at - kWaveBefore + Cycles{1});
  EXPECT_TRUE(waves.only_b.empty()) << waves.report();
  EXPECT_GT(waves.only_a.size(), 1'000u) << "every signal of the RTL";
  EXPECT_EQ(last_cycle(kRtlWaveFile), at + kWaveAfter);
  EXPECT_GT(last_cycle(kModelWaveFile), at) << "a pulse too many then ends its run";
}

TEST_F(EngineWaves, TheWaveformsOfEqualEnginesAreEqual) {
  const Scenario scenario = moving_scenario();
  write_engine_waves(scenario, Cycles{2'000}, folder_.path());
  const WaveComparison waves = compare_waves(file(kRtlWaveFile), file(kModelWaveFile));
  EXPECT_TRUE(waves.equal()) << waves.report();
  EXPECT_EQ(wave_cycle(waves.from_ps), Cycles{1}) << "the run begins there";
  EXPECT_EQ(wave_cycle(waves.to_ps), Cycles{2'000} + kWaveAfter);
}

TEST_F(EngineWaves, AStopRequestEndsBothRuns) {
  int asked = 0;
  write_engine_waves(moving_scenario(), Cycles{400'000}, folder_.path(),
                     {.stop_requested = [&] { return ++asked > 0; }});
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace armature::cosim
