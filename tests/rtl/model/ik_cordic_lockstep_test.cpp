// The model of ik_cordic against the verilated block, clock for clock.
#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "Vik_cordic.h"
#include "controller/regs/ik_cordic_regs.hpp"
#include "cosim/model/ik_cordic/ik_cordic.hpp"
#include "tests/rtl/model/block_lockstep.hpp"
#include "tests/support/random_ik_jobs.hpp"

namespace armature::test {
namespace {

namespace map = regs::ik_cordic;
using cosim::model::IkCordic;
using cosim::model::IkInputs;

class IkCordicLockstep : public BlockLockstep<Vik_cordic, IkCordic, IkInputs> {
 protected:
  static std::uint16_t offset(std::uint32_t first, std::uint32_t i = 0) {
    return static_cast<std::uint16_t>(first + 4 * i);
  }
  std::uint16_t random_address() {
    if (random_.below(40) == 0) return static_cast<std::uint16_t>(random_.below(0x10000));
    if (random_.below(4) == 0) return static_cast<std::uint16_t>(random_.below(0x20));
    if (random_.below(3) == 0) return static_cast<std::uint16_t>(random_.below(0x200));
    return static_cast<std::uint16_t>(map::kThetaOffset + random_.below(4 * map::kThetaCount));
  }
  // Jobs that a start may follow at once, later, or in the middle.
  BusTraffic random_write() override {
    if (queue_.empty() && random_.below(starts_) == 0) post_job();
    if (!queue_.empty() && random_.below(16) != 0) {
      const BusTraffic next = queue_.back();
      queue_.pop_back();
      return next;
    }
    const std::uint16_t address =
        random_.below(2) == 0 ? offset(map::kCtrlOffset, random_.below(3))
        : random_.below(4) == 0
            ? random_address()
            : static_cast<std::uint16_t>(map::kA1Offset + random_.below(map::kPreviousOffset + 12 - map::kA1Offset));
    BusTraffic write{.addr = address, .data = static_cast<std::uint32_t>(random_.next())};
    if (random_.below(4) == 0) write.wstrb = static_cast<std::uint8_t>(random_.below(16));
    return write;
  }
  std::uint16_t random_read() override { return random_address(); }
  void change_inputs() override {
    if (dut_.irq_o && !std::exchange(irq_, dut_.irq_o != 0)) ++irqs_;
    irq_ = dut_.irq_o != 0;
    const cosim::AxiSlavePins& pins = every_.port.pins();
    if (!pins.rvalid || pins.rresp != 0) return;
    const std::uint32_t read = every_.port.strobes().raddr & ~3u;
    if (read == map::kBranchesOffset && pins.rdata != 0) ++branches_;
    if (read == map::kStatusOffset && (pins.rdata & map::kStatusRefusedMask) != 0) ++refusals_;
    if (read == map::kStatusOffset && (pins.rdata & map::kStatusBusyMask) != 0) ++busy_;
  }
  void drive_inputs(Vik_cordic& /*dut*/, const IkInputs& /*in*/) override {}
  std::string difference(const Vik_cordic& dut, const IkCordic& block) override {
    if ((dut.irq_o != 0) == block.irq()) return {};
    std::ostringstream text;
    text << "irq RTL " << int{dut.irq_o} << " model " << block.irq();
    return text.str();
  }

  void post_job() {
    const cosim::model::ik::Job job = jobs_.next();
    const auto word = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
    const auto add = [this](std::uint32_t first, std::uint32_t i, std::uint32_t value) {
      queue_.push_back({.addr = offset(first, i), .data = value});
    };
    // The last one is written first.
    add(map::kCtrlOffset, 0, map::kCtrlStartMask | (job.five_r ? map::kCtrlFiveRMask : 0) | (random_.below(2) << 2));
    const std::array<std::uint32_t, 7> lengths{word(job.a1), word(job.base), job.upper,    job.fore,
                                               word(job.a4), word(job.hand), word(job.phi)};
    for (std::uint32_t i = 0; i < lengths.size(); ++i) add(map::kA1Offset, i, lengths[i]);
    for (std::uint32_t i = 0; i < map::kRotationCount; ++i) add(map::kRotationOffset, i, word(job.rotation[i]));
    for (std::uint32_t i = 0; i < map::kPositionCount; ++i) add(map::kPositionOffset, i, word(job.position[i]));
    add(map::kPreviousOffset, 0, word(job.previous1));
    add(map::kPreviousOffset, 1, word(job.previous2));
    add(map::kPreviousOffset, 2, word(job.previous4));
  }

  RandomIkJobs jobs_{20125};
  std::vector<BusTraffic> queue_;
  std::uint32_t starts_ = 1;
  bool irq_ = false;
  int irqs_ = 0, branches_ = 0, refusals_ = 0, busy_ = 0;
};

TEST_F(IkCordicLockstep, RandomTrafficIsThatOfTheBlockInEveryClock) {
  run(100'000, 1, 1);
  run(100'000, 12, 2);
  starts_ = 20;
  run(200'000, 60, 1);
  const std::pair<const char*, int> counts[]{{"interrupts", irqs_},
                                             {"reads of branches that exist", branches_},
                                             {"reads of a start that was refused", refusals_},
                                             {"reads while busy", busy_}};
  for (const auto& [what, count] : counts) {
    RecordProperty(what, count);
    EXPECT_GE(count, 50) << "too few " << what;
  }
}

TEST_F(IkCordicLockstep, ABlockAtRestIsNotComputed) {
  run(10'000, 12, 2);
  queue_.clear();
  for (int clock = 0; clock < 3'000; ++clock) {
    master_.drive(1);
    step();
  }
  const std::int64_t before = needed_.computed;
  for (int clock = 0; clock < 10'000; ++clock) {
    master_.drive(1);
    step();
    ASSERT_EQ(compare(), "") << "edge " << cycle_;
  }
  EXPECT_EQ(needed_.computed, before);
}

}  // namespace
}  // namespace armature::test
