#include "cosim/fabric/jittery_fabric.hpp"

#include <utility>

#include "cosim/fabric/pin_table.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {
namespace {

class JitteryFabric final : public Fabric {
 public:
  JitteryFabric(std::unique_ptr<Fabric> fabric, std::uint64_t seed) : fabric_{std::move(fabric)}, random_{seed} {}

  void set_inputs(const SocInputs& inputs) override {
    wanted_ = inputs;
    SocInputs now = inputs;
    for (const Pin& pin : pins()) {
      if (!pin.is_input()) continue;
      const std::uint32_t changed = pin.get(inputs, {}) ^ pin.get(seen_, {});
      if (changed == 0) continue;
      pin.set(now, pin.get(inputs, {}) ^ (changed & static_cast<std::uint32_t>(random_.next() >> 32)));
    }
    apply(now);
  }
  void set_master(const AxiMasterPins& master) override { fabric_->set_master(master); }

  bool run(std::int64_t limit) override {
    if (seen_ == wanted_) return fabric_->run(limit);
    const bool changed = fabric_->run(1);
    apply(wanted_);
    return changed || (limit > 1 && fabric_->run(limit - 1));
  }
  void stand_still(std::int64_t cycles) override { fabric_->stand_still(cycles); }
  void stop_clock_of(ClockGroup group) override { fabric_->stop_clock_of(group); }

  [[nodiscard]] const SocOutputs& outputs() const override { return fabric_->outputs(); }
  [[nodiscard]] AxiSlavePins slave() const override { return fabric_->slave(); }
  [[nodiscard]] Cycles cycle() const override { return fabric_->cycle(); }
  void open_wave(const std::filesystem::path& file, WaveFormat format) override { fabric_->open_wave(file, format); }
  void close_wave() override { fabric_->close_wave(); }

 private:
  void apply(const SocInputs& inputs) {
    seen_ = inputs;
    fabric_->set_inputs(inputs);
  }

  std::unique_ptr<Fabric> fabric_;
  Random random_;
  SocInputs wanted_;  // levels at the pins
  SocInputs seen_;    // levels that the next edge samples
};

}  // namespace

std::unique_ptr<Fabric> with_input_jitter(std::unique_ptr<Fabric> fabric, std::uint64_t seed) {
  return std::make_unique<JitteryFabric>(std::move(fabric), seed);
}

}  // namespace armature::cosim
