// Half periods through the whole logic: which counts of 0..200 come out, from the driver's write to the step pin.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

#include "controller/drivers/axi_timer.hpp"
#include "controller/drivers/pulse_width.hpp"
#include "controller/motion/half_period.hpp"
#include "cosim/bus/axi_lite_master.hpp"
#include "cosim/fabric/verilated_fabric.hpp"

namespace armature::cosim {
namespace {

// The register bus of a core that has the logic for itself; counts rising edges on the step pins.
class FabricBus final : public RegisterBus {
 public:
  FabricBus() : fabric_{make_verilated_fabric(Variant::kPaper)} { fabric_->set_inputs(SocInputs{}); }

  PerAxis<std::int64_t> pins{};  // net of direction
  bool decode_error = false;

  std::uint32_t read32(RegAddr addr) noexcept override { return access({.write = false, .addr = addr.value}); }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    access({.write = true, .addr = addr.value, .data = value});
  }
  // Runs to the next trigger, whose edge starts the widths written so far.
  Interrupts wait_for_interrupt(Interrupts) noexcept override {
    const std::int64_t triggers = triggers_;
    while (triggers_ == triggers) run(kTickCycles.value());
    return Interrupts::kTimer;
  }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return fabric_->cycle(); }
  void charge(Work, std::int64_t) noexcept override {}

 private:
  std::uint32_t access(const BusRequest& request) {
    master_.start(request, now());
    while (true) {
      const std::int64_t ahead = (master_.next_event() - now()).value();
      if (ahead > 0) {
        run(ahead);
        continue;
      }
      const std::optional<BusResponse> response = master_.step(now(), fabric_->slave());
      fabric_->set_master(master_.pins());
      if (!response) continue;
      decode_error = decode_error || response->error == BusError::kDecodeError;
      return response->data;
    }
  }
  void run(std::int64_t limit) {
    if (!fabric_->run(limit)) return;
    const SocOutputs& out = fabric_->outputs();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (((out.step & ~step_) >> axis & 1) != 0) pins[axis] += (out.dir >> axis & 1) != 0 ? 1 : -1;
    }
    step_ = out.step;
    if (out.trigger && !trigger_) ++triggers_;
    trigger_ = out.trigger;
  }

  std::unique_ptr<Fabric> fabric_;
  AxiLiteMaster master_{BusSpec{}, 1};
  std::uint8_t step_ = 0;
  bool trigger_ = false;
  std::int64_t triggers_ = 0;
};

class PaperFabric : public testing::Test {
 protected:
  PaperFabric() { AxiTimer{bus}.start(kTickCycles); }

  // What the six axes emit in a whole tick with these half periods: on the pins and by the registers.
  PerAxis<std::int64_t> emitted(const PerAxis<Cycles>& widths) {
    PulseWidth pulse_width{bus};
    pulse_width.set_widths(widths);
    (void)bus.wait_for_interrupt(Interrupts::kTimer);
    const PerAxis<std::int64_t> before = bus.pins;
    const PerAxis<std::int32_t> registers_before = pulse_width.emitted();
    (void)bus.wait_for_interrupt(Interrupts::kTimer);
    PerAxis<std::int64_t> pulses;
    for (std::size_t axis = 0; axis < kAxes; ++axis) pulses[axis] = bus.pins[axis] - before[axis];
    const PerAxis<std::int32_t> registers = pulse_width.emitted();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_EQ(registers[axis] - registers_before[axis], pulses[axis]) << "EMITTED of axis " << axis + 1;
    }
    return pulses;
  }

  // Every wanted count 0..200 in a tick of its own, the sign alternating. Lists those that come out wrong.
  int count_wrong(const char* name, const HalfPeriodTable& table) {
    int wrong = 0;
    std::string list;
    for (std::int64_t first = 0; first <= 200; first += std::int64_t{kAxes}) {
      const auto wanted = [first](std::size_t axis) {
        const std::int64_t n = first + static_cast<std::int64_t>(axis);
        return n % 2 == 0 ? n : -n;
      };
      const PerAxis<Cycles> widths = make_per_axis([&](std::size_t axis) { return table.width(Pulses{wanted(axis)}); });
      const PerAxis<std::int64_t> pulses = emitted(widths);
      for (std::size_t axis = 0; axis < kAxes && std::abs(wanted(axis)) <= 200; ++axis) {
        const std::int64_t n = wanted(axis);
        EXPECT_EQ(pulses[axis], pulses_of_width(widths[axis]).value()) << name << ", wanted " << n;
        if (pulses[axis] == n) continue;
        ++wrong;
        const std::int64_t off = std::abs(pulses[axis]) - std::abs(n);
        list += ' ' + std::to_string(std::abs(n)) + (off > 0 ? "+" : "") + std::to_string(off);
      }
    }
    std::cout << name << ": " << wrong << " of the counts 1..200 come out wrong:" << list << '\n';
    return wrong;
  }

  FabricBus bus;
};

TEST_F(PaperFabric, HundredAndThirtySixCountsComeOutWrong) {
  EXPECT_EQ(count_wrong("shortest half period 7 cycles", HalfPeriodTable{HalfPeriodLimits{}}), 200 - 64);
}

TEST_F(PaperFabric, HundredAndFortyWithPulsesThatADriveAccepts) {
  const HalfPeriodLimits drive{.min_width = Cycles{5}, .min_high = Cycles{5}, .dir_hold = Cycles{25}};
  EXPECT_EQ(count_wrong("no pulse below 100 ns", HalfPeriodTable{drive}), 200 - 60);
}

TEST_F(PaperFabric, AWidthGoesOnUntilItIsReplaced) {
  PerAxis<Cycles> widths;
  widths.fill(Cycles{-100});
  EXPECT_EQ(emitted(widths)[5], -12);
  (void)bus.wait_for_interrupt(Interrupts::kTimer);
  const std::int64_t before = bus.pins[5];
  for (int tick = 0; tick < 5; ++tick) (void)bus.wait_for_interrupt(Interrupts::kTimer);
  EXPECT_EQ(bus.pins[5] - before, 5 * -12);
}

}  // namespace
}  // namespace armature::cosim
