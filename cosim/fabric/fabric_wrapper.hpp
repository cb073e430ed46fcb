// A fabric that passes every call on to another one. A derived class overrides the calls that it treats differently.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

class FabricWrapper : public Fabric {
 public:
  void set_inputs(const SocInputs& inputs) override { inner_->set_inputs(inputs); }
  void set_master(const AxiMasterPins& pins) override { inner_->set_master(pins); }
  bool run(std::int64_t limit) override { return inner_->run(limit); }
  void stand_still(std::int64_t cycles) override { inner_->stand_still(cycles); }
  void stop_clock_of(ClockGroup group) override { inner_->stop_clock_of(group); }
  [[nodiscard]] std::vector<Flop> flops() override { return inner_->flops(); }
  bool flip(std::string_view flop, int bit) override { return inner_->flip(flop, bit); }
  [[nodiscard]] std::uint64_t digest() override { return inner_->digest(); }
  [[nodiscard]] const SocOutputs& outputs() const override { return inner_->outputs(); }
  [[nodiscard]] AxiSlavePins slave() const override { return inner_->slave(); }
  [[nodiscard]] Cycles cycle() const override { return inner_->cycle(); }
  void add_to_waves(const SoftwareSignals& signals) override { inner_->add_to_waves(signals); }
  void open_wave(const std::filesystem::path& file, WaveFormat format) override { inner_->open_wave(file, format); }
  void close_wave() override { inner_->close_wave(); }

 protected:
  explicit FabricWrapper(std::unique_ptr<Fabric> inner) : inner_{std::move(inner)} {}
  [[nodiscard]] Fabric& inner() { return *inner_; }
  [[nodiscard]] const Fabric& inner() const { return *inner_; }

 private:
  std::unique_ptr<Fabric> inner_;
};

}  // namespace armature::cosim
