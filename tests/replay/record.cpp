// record counts|paper MOVE.txt RANDOM.txt: records arm_soc in the simulator to two vector files (vectors.hpp): a
// joint move with the real controller, and random traffic on every pin. For the variant `paper` it records random
// traffic only and does not write MOVE.txt.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <utility>

#include "controller/base/words.hpp"
#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/replay/random_session.hpp"
#include "tests/replay/vectors.hpp"
#include "tests/support/pin_soc.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::test {
namespace {

using namespace cosim;

constexpr std::uint64_t kSeed = 20210604;
constexpr std::int64_t kRandomClocks = 60'000;

// Forwards to another fabric and writes the pins at each clock edge.
class Recorder final : public FabricWrapper {
 public:
  Recorder(std::unique_ptr<Fabric> fabric, const std::filesystem::path& file)
      : FabricWrapper{std::move(fabric)}, file_{file, "w"} {}

  void set_inputs(const SocInputs& inputs) override {
    inputs_ = inputs;
    inner().set_inputs(inputs);
  }
  void set_master(const AxiMasterPins& pins) override {
    master_ = pins;
    inner().set_master(pins);
  }
  bool run(std::int64_t limit) override {
    for (std::int64_t i = 0; i < limit; ++i) {
      const bool changed = inner().run(1);
      file_.write(pack(inputs_, master_, inner().outputs(), inner().slave()));
      if (changed) return true;
    }
    return false;
  }
  void open_wave(const std::filesystem::path&, WaveFormat) override {}
  void close_wave() override {}

 private:
  VectorFile file_;
  SocInputs inputs_;
  AxiMasterPins master_;
};

class Silent final : public cosim::test::SilentListener {
 public:
  void on_row(TraceRow& row) override {
    for (const std::int64_t pulses : row.pin_pulses) moved_ = moved_ || pulses != 0;
  }
  bool moved() const { return moved_; }

 private:
  bool moved_ = false;
};

// The first 2 ms of the move of Figure 9, fast enough for pulses on every axis.
void record_move(const std::filesystem::path& file) {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario = load_scenario(scenarios / "fig9_joint_move", {.search_path = scenarios, .overrides = {}});
  scenario.duration_s = 0.0021;
  scenario.moves.front().at_s = 0;
  Silent listener;
  const SimulationEnd end = cosim::test::run_to_end(Simulation{
      scenario,
      cosim::test::pin_soc(std::make_unique<Recorder>(make_verilated_fabric(), file), scenario.bus, scenario.seed),
      listener});
  if (end.reason != EndReason::kFinished) throw std::runtime_error(end.failure);
  if (!listener.moved()) throw std::runtime_error("the recorded move has no pulse");
}

void record_random(Variant variant, const std::filesystem::path& file) {
  Recorder recorder{make_verilated_fabric(variant), file};
  RandomSession{kSeed}.run(recorder, kRandomClocks);
}

}  // namespace
}  // namespace armature::test

int main(int argc, char** argv) {
  using namespace armature;
  const auto variant = enumerator_of<cosim::Variant>(argc > 1 ? argv[1] : "");
  if (argc != 4 || !variant) {
    std::fputs("usage: record counts|paper MOVE.txt RANDOM.txt\n", stderr);
    return 2;
  }
  try {
    if (variant == cosim::Variant::kCounts) test::record_move(argv[2]);
    test::record_random(*variant, argv[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "record: %s\n", error.what());
    return 1;
  }
  return 0;
}
