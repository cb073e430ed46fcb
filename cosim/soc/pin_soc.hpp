// A Soc whose logic is computed clock edge by clock edge: a Fabric, and the AXI4-Lite master on its port.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "cosim/bus/axi_lite_master.hpp"
#include "cosim/bus/bus_spec.hpp"
#include "cosim/fabric/fabric.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

class PinSoc final : public Soc {
 public:
  // `fabric` must be at cycle 0. `seed` is for the random stalls of `bus`.
  PinSoc(std::unique_ptr<Fabric> fabric, const BusSpec& bus, std::uint64_t seed);

  [[nodiscard]] Cycles now() const override { return fabric_->cycle(); }
  bool advance(Cycles limit, StopOn stop_on) override;
  void set_clock_running(bool running) override;
  void stop_clock_of(ClockGroup group) override { fabric_->stop_clock_of(group); }

  [[nodiscard]] std::vector<Flop> flops() override { return fabric_->flops(); }
  bool flip(std::string_view flop, int bit) override { return fabric_->flip(flop, bit); }
  [[nodiscard]] std::uint64_t digest() override { return fabric_->digest() ^ responses_; }

  [[nodiscard]] bool idle() const override { return master_.idle() && !response_; }
  std::optional<Cycles> start(const BusRequest& request) override;  // always none: the end is not known in advance
  [[nodiscard]] bool has_response() const override { return response_.has_value(); }
  std::optional<BusResponse> pop_response() override;
  [[nodiscard]] Cycles access_timeout() const override { return access_timeout_; }

  void set_inputs(const SocInputs& inputs) override { fabric_->set_inputs(inputs); }
  [[nodiscard]] const SocOutputs& outputs() const override { return fabric_->outputs(); }
  [[nodiscard]] std::uint8_t interrupts() const override { return fabric_->outputs().irq; }

  void add_to_waves(const SoftwareSignals& signals) override { fabric_->add_to_waves(signals); }
  void open_wave(const std::filesystem::path& file, WaveFormat format) override;
  void close_wave() override { fabric_->close_wave(); }

 private:
  // Steps the access that is under way. Returns whether it has finished.
  bool step_access();

  std::unique_ptr<Fabric> fabric_;
  AxiLiteMaster master_;
  std::optional<BusResponse> response_;  // not popped yet
  Cycles access_timeout_;
  std::uint64_t responses_ = 0;  // digest of all of them
  bool clock_running_ = true;
  Cycles stopped_at_{};  // of a clock that does not run
};

}  // namespace armature::cosim
