#include "controller/language/job/execute/pins.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/language/job/cartesian_rigs.hpp"

namespace armature::job {
namespace {

using test::alarm_of;
using test::executed;
using test::job_of;
using test::MachineRig;
using test::MovingRig;
using testing::ElementsAre;
using testing::IsEmpty;
using Progress = Program::Progress;

TEST(Pins, SendsOutputsAndTimesAheadOfTheArm) {
  MachineRig rig{job_of("DOUT OT#(3) ON\nTIMER T=0.50\nSET I000 25\nTIMER T=I000\nWAIT T=1.00\nDOUT OT#(3) OFF\n")};
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kEnded);
  ASSERT_EQ(rig.port.sent.size(), 5U);
  EXPECT_EQ(rig.port.sent_as<SetOutput>(0).pin, 3);
  EXPECT_TRUE(rig.port.sent_as<SetOutput>(0).level);
  EXPECT_EQ(rig.port.sent_as<Dwell>(1).duration, Ticks{10'000});
  EXPECT_EQ(rig.port.sent_as<Dwell>(2).duration, Ticks{5'000});
  EXPECT_EQ(rig.port.sent_as<Dwell>(3).duration, Ticks{20'000});
  EXPECT_FALSE(rig.port.sent_as<SetOutput>(4).level);
  EXPECT_EQ(rig.port.sent[4].second, Machine::place_of(0, 12));
}

TEST(Pins, SwitchesEachOutputOfAGroup) {
  MachineRig rig{job_of("DOUT OGH#(2) 5\nSET B000 129\nDOUT OG#(2) B000\n")};
  rig.port.room = 3;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 3U);
  rig.port.room = 100;
  EXPECT_EQ(rig.run(), Progress::kEnded);
  ASSERT_EQ(rig.port.sent.size(), 12U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(rig.port.sent_as<SetOutput>(i).pin, 5 + i);
    EXPECT_EQ(rig.port.sent_as<SetOutput>(i).level, i == 0 || i == 2);
  }
  EXPECT_EQ(rig.port.sent_as<SetOutput>(4).pin, 9);
  EXPECT_TRUE(rig.port.sent_as<SetOutput>(4).level);
  EXPECT_TRUE(rig.port.sent_as<SetOutput>(11).level);
  EXPECT_FALSE(rig.port.sent_as<SetOutput>(10).level);
  EXPECT_EQ(alarm_of("DOUT OGH#(1) 16\n"), "DOUT: a value out of the range of its variable");
  EXPECT_EQ(alarm_of("SET I000 0\nDOUT OT#(I000) ON\n"), "DOUT: no pin of this number");
}

TEST(Pins, KeepsTheLevelOfOutputsThatHaveNoPin) {
  auto rig = executed("DOUT OT#(890) ON\nDIN B000 OT#(890)\nDIN B001 OT#(891)\nPULSE OT#(4000) T=1.00\n");
  EXPECT_THAT(rig.port.sent, IsEmpty());
  EXPECT_EQ(rig.b(0), 1);
  EXPECT_EQ(rig.b(1), 0);
  EXPECT_EQ(alarm_of("DIN B000 IN#(17)\n"), "DIN: no pin of this number");
  EXPECT_EQ(alarm_of("DIN B000 RIN#(1)\n"), "DIN: not supported");
}

TEST(Pins, ReadsInputsWhenTheArmStands) {
  MachineRig rig{test::moving_job_of("MOVJ C1\nDIN B000 IN#(2)\nDIN B001 IG#(1)\nDIN B002 IGH#(2)\n")};
  rig.port.inputs[2] = rig.port.inputs[5] = rig.port.inputs[8] = true;
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 1U);
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
  EXPECT_EQ(rig.b(1), 0b1001'0010);
  EXPECT_EQ(rig.b(2), 0b1001);
}

TEST(Pins, WaitsForAConditionTickByTick) {
  MachineRig rig{job_of("WAIT IN#(1)=ON\nSET B000 1\n")};
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  EXPECT_TRUE(rig.machine->waits_for_time());
  rig.port.inputs[1] = true;
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_FALSE(rig.machine->waits_for_time());
  EXPECT_EQ(rig.b(0), 1);
}

TEST(Pins, ContinuesWhenTheTimeOfAWaitIsOver) {
  MachineRig rig{job_of("WAIT IN#(1)=ON T=0.10\nSET B000 1\n")};
  rig.port.time = Ticks{500};
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.time = Ticks{2'499};
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.time = Ticks{2'500};
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
}

TEST(Pins, PulsesAnOutputWithoutWaiting) {
  MachineRig rig{job_of("PULSE OT#(4) T=0.20\nPULSE OT#(5)\nSET B000 1\n")};
  rig.port.arrived = false;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  EXPECT_THAT(rig.port.pulses, IsEmpty());
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
  EXPECT_THAT(rig.port.pulses, ElementsAre(std::pair{4, Ticks{4'000}}, std::pair{5, Ticks{6'000}}));
}

TEST(Pins, WaitsForRoom) {
  MachineRig rig{job_of("TIMER T=1.00\nTIMER T=1.00\nSET B000 1\n")};
  rig.port.room = 1;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  EXPECT_EQ(rig.port.sent.size(), 1U);
  EXPECT_EQ(rig.b(0), 0);
  rig.port.room = 1;
  EXPECT_EQ(rig.run(), Progress::kEnded);
}

TEST(Pins, WaitsForPinsAndNotForLevelsWithoutAPin) {
  EXPECT_TRUE(MovingRig{"MOVJ C0\nDIN B000 OT#(16)\n"}.waits_behind(1));
  EXPECT_TRUE(MovingRig{"MOVJ C0\nDIN B000 OG#(2)\n"}.waits_behind(1));
  EXPECT_TRUE(MovingRig{"MOVJ C0\nWAIT IN#(1)=OFF\n"}.waits_behind(1));
  MovingRig rig{"MOVJ C0\nDOUT OT#(17) ON\nDIN B000 OT#(17)\nDIN B001 OG#(3)\nWAIT OT#(17)=ON\nWAIT B000=1\nMOVL C1\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kEnded);
  EXPECT_EQ(rig.b(0), 1);
  EXPECT_EQ(rig.b(1), 1);
}

TEST(Pins, CountsTheTimeOfAWaitFromTheRestOn) {
  MovingRig rig{"MOVJ C0\nWAIT OT#(17)=ON T=1.00\n"};
  EXPECT_EQ(rig.run_ahead(), Progress::kWaiting);
  rig.port.time = Ticks{100'000};
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.arrived = true;
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.time = Ticks{120'000};
  EXPECT_EQ(rig.run(), Progress::kEnded);
}

TEST(Pins, CountTheTimeOfEachWaitFromItsOwnStart) {
  MachineRig rig{job_of("WAIT IN#(1)=ON T=0.10\nWAIT IN#(2)=ON T=0.10\nSET B000 1\n")};
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.time = Ticks{2'100};
  EXPECT_EQ(rig.run(), Progress::kWaiting);  // the second one has started
  rig.port.time = Ticks{4'099};
  EXPECT_EQ(rig.run(), Progress::kWaiting);
  rig.port.time = Ticks{4'100};
  EXPECT_EQ(rig.run(), Progress::kEnded);
}

}  // namespace
}  // namespace armature::job
