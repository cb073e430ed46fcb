// A fabric without logic: counts clock edges and remembers what was asked of its waveform.
#pragma once

#include <string>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

class FakeFabric final : public Fabric {
 public:
  void set_inputs(const SocInputs&) override {}
  void set_master(const AxiMasterPins&) override {}
  bool run(std::int64_t limit) override { return cycle_ += limit, false; }
  void stand_still(std::int64_t cycles) override { cycle_ += cycles; }
  void stop_clock_of(ClockGroup group) override {
    log.emplace_back("stop the clock of " + std::string{word_of(group)});
  }
  [[nodiscard]] const SocOutputs& outputs() const override { return outputs_; }
  [[nodiscard]] AxiSlavePins slave() const override { return {}; }
  [[nodiscard]] Cycles cycle() const override { return Cycles{cycle_}; }
  void open_wave(const std::filesystem::path& file, WaveFormat) override { log.push_back("open " + file.string()); }
  void close_wave() override { log.emplace_back("close"); }

  std::vector<std::string> log;

 private:
  SocOutputs outputs_;
  std::int64_t cycle_ = 0;
};

}  // namespace armature::cosim
