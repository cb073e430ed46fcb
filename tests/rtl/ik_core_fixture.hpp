// Fixture of ik_core with the integers of cosim/model/ik_cordic beside it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "Vik_core.h"
#include "cosim/model/ik_cordic/ik_solver.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

namespace ik = cosim::model::ik;

class IkCoreFixture : public VerilatedTest<Vik_core> {
 protected:
  IkCoreFixture() {
    dut_.ctrl_start_i = dut_.ctrl_five_r_i = dut_.ctrl_irq_i = 0;
    dut_.event_done_i = 0;
    reset();
  }

  void set(const ik::Job& job) {
    dut_.ctrl_five_r_i = job.five_r;
    dut_.a1_length_i = bits(job.a1);
    dut_.d1_length_i = bits(job.base);
    dut_.a2_length_i = job.upper;
    dut_.forearm_length_i = job.fore;
    dut_.a4_length_i = bits(job.a4);
    dut_.hand_length_i = bits(job.hand);
    dut_.phi_angle_i = bits(job.phi);
    for (std::size_t i = 0; i < job.rotation.size(); ++i) dut_.rotation_entry_i[i] = bits(job.rotation[i]);
    for (std::size_t i = 0; i < job.position.size(); ++i) dut_.position_coordinate_i[i] = bits(job.position[i]);
    dut_.previous_angle_i[0] = bits(job.previous1);
    dut_.previous_angle_i[1] = bits(job.previous2);
    dut_.previous_angle_i[2] = bits(job.previous4);
  }

  void start() {
    dut_.ctrl_start_i = 1;
    tick();
    dut_.ctrl_start_i = 0;
  }

  // Starts, and waits for the end. Returns the number of clocks that were busy.
  int run(const ik::Job& job) {
    set(job);
    start();
    int clocks = 0;
    for (; dut_.status_busy_o && clocks < kTimeout; ++clocks) tick();
    return clocks;
  }

  [[nodiscard]] ik::Solved results() const {
    ik::Solved solved;
    for (std::size_t branch = 0; branch < ik::kBranches; ++branch) {
      for (std::size_t joint = 0; joint < ik::kJoints; ++joint) {
        solved.theta[branch][joint] = static_cast<std::int32_t>(dut_.theta_angle_o[6 * branch + joint]);
      }
    }
    solved.valid = dut_.branches_valid_o;
    solved.shoulder_singular = dut_.flags_shoulder_o;
    solved.elbow_singular = dut_.flags_elbow_o;
    solved.clamped = dut_.flags_clamped_o;
    solved.folded = dut_.flags_folded_o;
    solved.wrist_singular = dut_.flags_wrist_o;
    return solved;
  }

  // Runs the job in the logic and in the model. Both must have the same bits and the same latency.
  void expect_the_model(const ik::Job& job) {
    ik::Solved expected = solve(job);
    const int clocks = run(job);
    EXPECT_FALSE(dut_.status_busy_o);
    EXPECT_TRUE(dut_.status_done_o);
    EXPECT_EQ(clocks, expected.clocks);
    EXPECT_EQ(dut_.cycles_value_o, expected.clocks);
    EXPECT_FALSE(expected.exceeded);
    const ik::Solved solved = results();
    expected.clocks = solved.clocks;
    EXPECT_EQ(solved, expected);
  }

  static constexpr int kTimeout = 2500;

 private:
  static std::uint32_t bits(std::int32_t value) { return static_cast<std::uint32_t>(value); }
};

}  // namespace armature::test
