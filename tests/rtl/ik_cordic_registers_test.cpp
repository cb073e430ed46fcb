// ik_cordic through its AXI port: every register sets or shows the thing it is named after.
#include "Vik_cordic.h"
#include "controller/regs/field.hpp"
#include "controller/regs/ik_cordic_regs.hpp"
#include "cosim/model/ik_cordic/ik_solver.hpp"
#include "tests/support/axi_stall_test.hpp"
#include "tests/support/ik_jobs.hpp"

namespace armature::test {
namespace {

namespace reg = regs::ik_cordic;

class IkCordicRegisters : public AxiStallTest<Vik_cordic> {
 protected:
  // The edges that the block need not have it gets, or not, at random.
  void clock() override {
    dut_.eval();  // active_o looks at inputs
    if (dut_.active_o || !dut_.rst_ni || random_.below(2) == 0) tick();
  }
  void wait_for_the_end() {
    for (int i = 0; i < 1300; ++i) clock();
  }

  void write_element(std::uint32_t first, std::size_t i, std::int32_t value) {
    write(first + 4 * static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(value));
  }

  // Whatever the job has, and what reads back.
  void write_job(const ik::Job& job) {
    const struct {
      std::uint32_t offset, value;
    } lengths[] = {{reg::kA1Offset, static_cast<std::uint32_t>(job.a1)},
                   {reg::kD1Offset, static_cast<std::uint32_t>(job.base)},
                   {reg::kA2Offset, job.upper},
                   {reg::kForearmOffset, job.fore},
                   {reg::kA4Offset, static_cast<std::uint32_t>(job.a4)},
                   {reg::kHandOffset, static_cast<std::uint32_t>(job.hand)},
                   {reg::kPhiOffset, static_cast<std::uint32_t>(job.phi)}};
    for (const auto& [offset, value] : lengths) {
      write(offset, value);
      EXPECT_EQ(read(offset), value);
    }
    for (std::size_t i = 0; i < 9; ++i) write_element(reg::kRotationOffset, i, job.rotation[i]);
    for (std::size_t i = 0; i < 3; ++i) write_element(reg::kPositionOffset, i, job.position[i]);
    const std::int32_t previous[] = {job.previous1, job.previous2, job.previous4};
    for (std::size_t i = 0; i < 3; ++i) write_element(reg::kPreviousOffset, i, previous[i]);
    EXPECT_EQ(read(reg::kRotationOffset + 4 * 8), static_cast<std::uint32_t>(job.rotation[8]));
    EXPECT_EQ(read(reg::kPositionOffset + 4 * 2), static_cast<std::uint32_t>(job.position[2]));
    EXPECT_EQ(read(reg::kPreviousOffset + 4 * 2), static_cast<std::uint32_t>(job.previous4));
  }

  void start(bool five_r, bool irq = false) {
    write(reg::kCtrlOffset, reg::kCtrlStartMask | (five_r ? reg::kCtrlFiveRMask : 0) | (irq ? reg::kCtrlIrqMask : 0));
  }

  static ik::Job some_job(bool five_r) {
    ik::Job job = six_r_job();
    job.five_r = five_r;
    job.a1 = kUnit;
    job.base = five_r ? 0 : 2 * kUnit;
    job.a4 = kUnit / 2;
    job.hand = 3 * kUnit;
    job.position = {7 * kUnit, 3 * kUnit, 5 * kUnit};
    return job;
  }

 private:
  SplitMix random_{kPowerUpSeed};
};
INSTANTIATE_AXI_STALLS(IkCordicRegisters);

TEST_P(IkCordicRegisters, IdentifiesItself) {
  EXPECT_EQ(read(reg::kIdOffset), 0x494B'0108U);
}

TEST_P(IkCordicRegisters, IsIdleAfterReset) {
  EXPECT_EQ(read(reg::kCtrlOffset), 0U);
  EXPECT_EQ(read(reg::kStatusOffset), 0U);
  EXPECT_EQ(read(reg::kEventOffset), 0U);
  EXPECT_EQ(read(reg::kBranchesOffset), 0U);
  EXPECT_EQ(read(reg::kFlagsOffset), 0U);
  EXPECT_FALSE(dut_.irq_o);
}

TEST_P(IkCordicRegisters, SolvesAPoseOfEachFamily) {
  for (const bool five_r : {false, true}) {
    const ik::Job job = some_job(five_r);
    const ik::Solved expected = solve(job);
    EXPECT_EQ(expected.valid, five_r ? 0x55 : 0xFF);
    write_job(job);
    start(five_r);
    EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusBusyMask);
    wait_for_the_end();
    EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusDoneMask);
    EXPECT_EQ(read(reg::kCyclesOffset), static_cast<std::uint32_t>(expected.clocks));
    EXPECT_EQ(read(reg::kBranchesOffset), expected.valid);
    for (std::size_t i = 0; i < reg::kThetaCount; ++i) {
      EXPECT_EQ(read(reg::kThetaOffset + 4 * static_cast<std::uint32_t>(i)),
                static_cast<std::uint32_t>(expected.theta[i / 6][i % 6]));
    }
  }
}

TEST_P(IkCordicRegisters, ShowsEachFlagPerShoulderAndElbow) {
  ik::Job job = six_r_job();
  job.upper = job.fore - 1000;
  job.a1 = 3 * kUnit;
  job.position = {3 * kUnit, 0, 0};  // the front folded onto axis 2
  write_job(job);
  start(false);
  wait_for_the_end();
  const ik::Solved expected = solve(job);
  const std::uint32_t flags = read(reg::kFlagsOffset);
  EXPECT_EQ(regs::extract(flags, reg::kFlagsFolded), 1U);
  EXPECT_EQ(regs::extract(flags, reg::kFlagsElbow), 1U);
  EXPECT_EQ(regs::extract(flags, reg::kFlagsClamped), 1U);
  EXPECT_EQ(regs::extract(flags, reg::kFlagsWrist), expected.wrist_singular);
  EXPECT_EQ(regs::extract(flags, reg::kFlagsShoulder), 0U);
  EXPECT_EQ(regs::extract(read(reg::kThetaOffset + 4), reg::kThetaAngle), static_cast<std::uint32_t>(job.previous2));
}

TEST_P(IkCordicRegisters, HidesTheResultsUntilTheEnd) {
  write_job(some_job(false));
  start(false);
  wait_for_the_end();
  const std::uint32_t theta = read(reg::kThetaOffset);
  EXPECT_NE(theta, 0U);
  start(false);
  for (int i = 0; i < 1000; ++i) clock();  // the front shoulder has its branches
  EXPECT_EQ(read(reg::kBranchesOffset), 0U);
  EXPECT_EQ(read(reg::kFlagsOffset), 0U);
  EXPECT_EQ(read(reg::kThetaOffset), 0U);
  EXPECT_EQ(read(reg::kA2Offset), some_job(false).upper);
  wait_for_the_end();
  EXPECT_EQ(read(reg::kBranchesOffset), 0xFFU);
  EXPECT_EQ(read(reg::kThetaOffset), theta);
}

TEST_P(IkCordicRegisters, InterruptIsTheEventIfItIsEnabled) {
  write_job(some_job(false));
  start(false, true);
  wait_for_the_end();
  EXPECT_EQ(read(reg::kEventOffset), reg::kEventDoneMask);
  EXPECT_TRUE(dut_.irq_o);
  write(reg::kCtrlOffset, 0);
  EXPECT_FALSE(dut_.irq_o);
  write(reg::kCtrlOffset, reg::kCtrlIrqMask);
  EXPECT_TRUE(dut_.irq_o);
  write(reg::kEventOffset, reg::kEventDoneMask);
  EXPECT_FALSE(dut_.irq_o);
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusDoneMask);
}

TEST_P(IkCordicRegisters, SecondStartIsRefused) {
  write_job(some_job(false));
  start(false);
  start(true);
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusBusyMask | reg::kStatusRefusedMask);
  wait_for_the_end();
  EXPECT_EQ(read(reg::kBranchesOffset), 0xFFU);
  start(false);
  EXPECT_EQ(read(reg::kStatusOffset), reg::kStatusBusyMask);
}

}  // namespace
}  // namespace armature::test
