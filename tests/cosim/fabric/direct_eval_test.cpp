// A fabric evaluates its edges directly, but with Verilator's eval() while it writes a waveform. The pins must be the
// same.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>

#include "controller/base/words.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

constexpr int kClocks = 20'000;
constexpr std::uint32_t kBlocks[] = {0x4120'0000, 0x4280'0000, 0x43C0'1000, 0x43C1'0000,
                                     0x43C2'0000, 0x43C3'0000, 0x43C4'0000, 0x43C5'0000};

// Random pins, and accesses to random registers of every block. A VALID stays until it is accepted.
class Surroundings {
 public:
  explicit Surroundings(std::uint64_t seed) : random_{seed} {}

  SocInputs inputs() {
    SocInputs in;
    in.enc_a = bits();
    in.enc_b = bits();
    in.enc_z = bits();
    in.home = bits();
    in.drive_alarm = bits();
    in.estop_n = random_.below(200) != 0;
    in.uart_rxd = random_.below(50) != 0;
    in.gpio = static_cast<std::uint16_t>(random_.below(4));
    in.capture_trig = random_.below(50) == 0;
    return in;
  }

  // `slave`: the levels before the next edge.
  const AxiMasterPins& master(const AxiSlavePins& slave) {
    if (previous_.awready) pins_.awvalid = false;
    if (previous_.wready) pins_.wvalid = false;
    if (previous_.arready) pins_.arvalid = false;
    previous_ = slave;
    if (!pins_.awvalid && !pins_.wvalid && random_.below(8) == 0) {
      pins_.awvalid = pins_.wvalid = true;
      pins_.awaddr = address();
      pins_.wdata = static_cast<std::uint32_t>(random_.below(1u << 12));
      pins_.wstrb = 0xF;
    }
    if (!pins_.arvalid && random_.below(8) == 0) {
      pins_.arvalid = true;
      pins_.araddr = address();
    }
    pins_.bready = random_.below(2) == 0;
    pins_.rready = random_.below(2) == 0;
    return pins_;
  }

 private:
  // The levels are constant most of the time, so that the blocks become idle.
  std::uint8_t bits() {
    if (random_.below(20) == 0) held_ = static_cast<std::uint8_t>(random_.below(64));
    return held_;
  }
  std::uint32_t address() {
    return kBlocks[random_.below(std::size(kBlocks))] + 4 * static_cast<std::uint32_t>(random_.below(64));
  }

  test::SplitMix random_;
  std::uint8_t held_ = 0;
  AxiMasterPins pins_;
  AxiSlavePins previous_;  // before the last edge
};

bool same(const AxiSlavePins& a, const AxiSlavePins& b) {
  return a.awready == b.awready && a.wready == b.wready && a.bvalid == b.bvalid && a.bresp == b.bresp &&
         a.arready == b.arready && a.rvalid == b.rvalid && a.rresp == b.rresp && a.rdata == b.rdata;
}

class DirectEval : public testing::TestWithParam<Variant> {};

TEST_P(DirectEval, GivesThePinsOfEvalAlsoAfterAWaveform) {
  const auto file = std::filesystem::temp_directory_path() / ("armature_direct_" + std::to_string(getpid()) + ".vcd");
  const std::unique_ptr<Fabric> direct = make_verilated_fabric(GetParam());
  const std::unique_ptr<Fabric> traced = make_verilated_fabric(GetParam());
  Surroundings surroundings{20210417};
  traced->open_wave(file, WaveFormat::kVcd);
  for (int clock = 0; clock < kClocks; ++clock) {
    if (clock == kClocks / 2) traced->close_wave();  // from here on both evaluate directly
    const SocInputs inputs = surroundings.inputs();
    const AxiMasterPins& master = surroundings.master(direct->slave());
    for (Fabric* fabric : {direct.get(), traced.get()}) {
      fabric->set_inputs(inputs);
      fabric->set_master(master);
      fabric->run(1);
    }
    ASSERT_TRUE(direct->outputs() == traced->outputs()) << "clock " << clock;
    ASSERT_TRUE(same(direct->slave(), traced->slave())) << "clock " << clock;
  }
  std::filesystem::remove(file);
}

TEST_P(DirectEval, GivesThePinsOfEvalWhenAClockHasStopped) {
  const auto file = std::filesystem::temp_directory_path() / ("armature_stopped_" + std::to_string(getpid()) + ".vcd");
  for (const ClockGroup group : {ClockGroup::kIo, ClockGroup::kMotion, ClockGroup::kEncoder}) {
    const std::unique_ptr<Fabric> direct = make_verilated_fabric(GetParam());
    const std::unique_ptr<Fabric> traced = make_verilated_fabric(GetParam());
    Surroundings surroundings{1729};
    traced->open_wave(file, WaveFormat::kVcd);
    for (int clock = 0; clock < kClocks / 4; ++clock) {
      const SocInputs inputs = surroundings.inputs();
      const AxiMasterPins& master = surroundings.master(direct->slave());
      for (Fabric* fabric : {direct.get(), traced.get()}) {
        if (clock == kClocks / 8) fabric->stop_clock_of(group);
        fabric->set_inputs(inputs);
        fabric->set_master(master);
        fabric->run(1);
      }
      ASSERT_TRUE(direct->outputs() == traced->outputs()) << word_of(group) << ", clock " << clock;
      ASSERT_TRUE(same(direct->slave(), traced->slave())) << word_of(group) << ", clock " << clock;
    }
    traced->close_wave();
  }
  std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(Variants, DirectEval, testing::Values(Variant::kCounts, Variant::kPaper));

}  // namespace
}  // namespace armature::cosim
