// Fixture: a verilated block and its model, clock for clock, under random legal traffic on the bus and random inputs.
//
// Three copies run: the verilated block, a model that computes every edge, and a model that computes only the edges
// that it must (cosim/model/block.hpp). All outputs and all pins of the bus are equal after every edge.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include "cosim/model/block.hpp"
#include "cosim/model/bus_port.hpp"
#include "tests/support/random_master.hpp"
#include "tests/support/split_mix.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

// Dut: verilated block with the flat ports s_axi_*. Block: its model; Inputs: its struct of inputs, with operator==.
template <class Dut, class Block, class Inputs>
class BlockLockstep : public VerilatedTest<Dut> {
 protected:
  struct Copy {
    Block block{};
    cosim::model::BusPort port;
    Inputs latest{};  // of the latest computed edge, after its trigger
    std::int64_t computed = 0;
  };

  // ---- the derived fixture says
  virtual BusTraffic random_write() = 0;
  virtual std::uint16_t random_read() = 0;
  virtual void change_inputs() = 0;                           // changes inputs_ now and then
  virtual void drive_inputs(Dut& dut, const Inputs& in) = 0;  // to the ports of the block
  // Text of an output that differs, with both values; empty when all are equal.
  virtual std::string difference(const Dut& dut, const Block& block) = 0;

  void SetUp() override {
    drive_inputs(this->dut_, inputs_);
    drive_bus(this->dut_, {});
    this->reset();
  }

  // Resets everything, with the present levels of the inputs.
  void restart() {
    every_ = needed_ = {};
    master_.reset();
    gated_clock_runs_ = true;
    this->context_.assertOn(true);
    SetUp();
  }

  // From now on there are no edges of clk_gated_i (rtl/README.md), until restart(). The bus port stands still too. Some
  // assertions of the RTL rely on this clock.
  void stop_gated_clock() {
    gated_clock_runs_ = false;
    this->context_.assertOn(false);
    every_.block.stop_gated_clock();
    needed_.block.stop_gated_clock();
  }

  // Runs `clocks` edges. `gap`: mean number of clocks between accesses in a direction; `lazy`: see RandomMaster.
  void run(std::int64_t clocks, std::uint32_t gap, std::uint32_t lazy) {
    for (std::int64_t i = 0; i < clocks; ++i) {
      if (!master_.writes() && random_.below(gap) == 0) master_.write(random_write());
      if (!master_.reads() && random_.below(gap) == 0) master_.read(random_read());
      master_.drive(lazy);
      change_inputs();
      step();
      const std::string what = compare();
      ASSERT_EQ(what, "") << "seed " << kSeed << ", edge " << this->cycle_;
      ASSERT_GT(needed_.block.wakes_at().value(), this->cycle_) << "seed " << kSeed;
      if (this->HasFailure()) return;
    }
  }

  // One edge of all copies.
  void step() {
    const cosim::AxiMasterPins pins = master_.pins();
    drive_inputs(this->dut_, inputs_);
    drive_bus(this->dut_, pins);
    const cosim::AxiSlavePins before = every_.port.pins();
    if (gated_clock_runs_) {
      this->tick();
    } else {
      tick_without_gated_clock();
    }
    const Cycles at{this->cycle_};
    edge(every_, at, pins, true);
    const bool must = needed_.port.strobes().any() || needed_.block.wakes_at() <= at || !(inputs_ == needed_.latest) ||
                      needed_.computed == 0;
    edge(needed_, at, pins, must);
    master_.edge(before);
  }

  std::string compare() {
    const Dut& dut = this->dut_;
    for (Copy* copy : {&every_, &needed_}) {
      const std::string which = copy == &every_ ? "every edge computed: " : "only needed edges computed: ";
      const cosim::AxiSlavePins& pins = copy->port.pins();
      const auto differs = [&](std::string_view name, std::uint32_t rtl, std::uint32_t model) {
        if (rtl == model) return std::string{};
        std::ostringstream text;
        text << which << name << std::hex << " RTL 0x" << rtl << " model 0x" << model;
        return text.str();
      };
      if (auto t = differs("awready", dut.s_axi_awready_o, pins.awready); !t.empty()) return t;
      if (auto t = differs("wready", dut.s_axi_wready_o, pins.wready); !t.empty()) return t;
      if (auto t = differs("bvalid", dut.s_axi_bvalid_o, pins.bvalid); !t.empty()) return t;
      if (auto t = differs("arready", dut.s_axi_arready_o, pins.arready); !t.empty()) return t;
      if (auto t = differs("rvalid", dut.s_axi_rvalid_o, pins.rvalid); !t.empty()) return t;
      if (pins.bvalid) {
        if (auto t = differs("bresp", dut.s_axi_bresp_o, pins.bresp); !t.empty()) return t + last_access();
      }
      if (pins.rvalid) {
        if (auto t = differs("rdata", dut.s_axi_rdata_o, pins.rdata); !t.empty()) return t + last_access();
        if (auto t = differs("rresp", dut.s_axi_rresp_o, pins.rresp); !t.empty()) return t + last_access();
      }
      if (auto t = difference(dut, copy->block); !t.empty()) return which + t;
    }
    return {};
  }

  std::string last_access() const {
    std::ostringstream text;
    text << std::hex << " (write at 0x" << every_.port.strobes().waddr << ", read at 0x" << every_.port.strobes().raddr
         << ")";
    return text.str();
  }

  static constexpr std::uint64_t kSeed = 2021;
  SplitMix random_{kSeed};
  RandomMaster master_{random_};
  Inputs inputs_{};
  Copy every_, needed_;

 private:
  static void drive_bus(Dut& dut, const cosim::AxiMasterPins& m) {
    dut.s_axi_awaddr_i = static_cast<SData>(m.awaddr);
    dut.s_axi_awvalid_i = m.awvalid;
    dut.s_axi_wdata_i = m.wdata;
    dut.s_axi_wstrb_i = m.wstrb;
    dut.s_axi_wvalid_i = m.wvalid;
    dut.s_axi_bready_i = m.bready;
    dut.s_axi_araddr_i = static_cast<SData>(m.araddr);
    dut.s_axi_arvalid_i = m.arvalid;
    dut.s_axi_rready_i = m.rready;
  }

  void edge(Copy& copy, Cycles at, const cosim::AxiMasterPins& pins, bool compute) {
    cosim::model::Answer answer;
    if (compute) {
      answer = copy.block.edge(at, copy.port.strobes(), inputs_);
      copy.latest = cosim::model::after_trigger(inputs_);
      ++copy.computed;
    }
    if (gated_clock_runs_) copy.port.edge(pins, answer);
  }

  void tick_without_gated_clock() {
    for (const bool level : {true, false}) {
      this->dut_.clk_i = level;
      this->dut_.eval();
    }
    ++this->cycle_;
  }

  bool gated_clock_runs_ = true;
};

}  // namespace armature::test
