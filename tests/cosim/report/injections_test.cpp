// Injected faults and inputs, and what counts as the system's answer to them.
#include "cosim/report/measure/injections.hpp"

#include <gtest/gtest.h>

#include "cosim/report/format/injection_text.hpp"

namespace armature::cosim {
namespace {

FaultSpec pulse_loss(int axis, std::int64_t count) {
  return {.at_s = 0, .kind = PulseLoss{.axis = axis, .count = count}};
}

FaultSpec slow_core(double compute_us) {
  return {.at_s = 0, .kind = SlowCore{.compute_us = compute_us}};
}

FaultSpec estop(double duration_s) {
  return {.at_s = 0, .kind = Estop{.duration_s = duration_s}};
}

InputSpec input(std::int64_t pin, bool level) {
  InputSpec spec;
  spec.pin = pin;
  spec.level = level;
  return spec;
}

CommandSpec wait_din(std::uint32_t index) {
  CommandSpec move;
  move.kind = WaitDinSpec{};
  move.index = index;
  return move;
}

TEST(Injections, EachPulseLossCountsItsOwnPulsesInTheOrderOfTheFaults) {
  InjectionMeter meter;
  meter.add(pulse_loss(3, 500), {.tick = 0, .at = Cycles{1000}});
  meter.add(pulse_loss(3, 100), {.tick = 0, .at = Cycles{2000}});
  meter.add(pulse_loss(4, 7), {.tick = 1, .at = Cycles{3000}});
  TraceRow row;
  row.pulses_to_drop[2] = 130;
  row.pulses_to_drop[3] = 7;
  meter.add(row);
  EXPECT_EQ(meter.faults()[0].lost_pulses, 470);
  EXPECT_EQ(meter.faults()[1].lost_pulses, 0);
  EXPECT_EQ(meter.faults()[2].lost_pulses, 0);
  row.pulses_to_drop = {0, 0, 40, 0, 0, 0};
  meter.add(row);
  EXPECT_EQ(meter.faults()[0].lost_pulses, 500);
  EXPECT_EQ(meter.faults()[1].lost_pulses, 60);
  EXPECT_EQ(meter.faults()[2].lost_pulses, 7);
}

TEST(Injections, WhatHappensAnswersTheLastInjectedFault) {
  InjectionMeter meter;
  meter.servo_enables(0x3F, Cycles{10});
  TraceRow row;
  row.telemetry.underruns = 2;  // before any fault
  meter.add(row);
  meter.add(slow_core(60), {.tick = 1, .at = Cycles{1'000}});
  row.telemetry.underruns = 3;
  meter.add(row);
  meter.add(slow_core(300), {.tick = 2, .at = Cycles{5'000}});
  row.telemetry.underruns = 7;
  meter.add(row);
  meter.servo_enables(0, Cycles{15'000});
  meter.servo_enables(0x3F, Cycles{16'000});
  meter.servo_enables(0, Cycles{17'000});
  meter.add(FaultEvent{.cause = FaultCause::kWatchdog, .where = {.at = Cycles{15'500}, .axis = 0}});
  meter.add(FaultEvent{.cause = FaultCause::kEncoder, .where = {.at = Cycles{15'600}, .axis = 1}});

  EXPECT_EQ(meter.faults()[0].underruns, 1);
  EXPECT_FALSE(meter.faults()[0].servo_off);
  EXPECT_FALSE(meter.faults()[0].stop_ticks());
  EXPECT_FALSE(meter.faults()[0].fault);
  EXPECT_EQ(meter.faults()[1].underruns, 4);
  EXPECT_EQ(meter.faults()[1].servo_off, Cycles{15'000});
  EXPECT_EQ(meter.faults()[1].stop_ticks(), 4);
  EXPECT_EQ(meter.faults()[1].fault->cause, FaultCause::kWatchdog);
  EXPECT_EQ(answer_text(meter.faults()[0]), "1 underruns, the controller reports no fault");
  EXPECT_EQ(answer_text(meter.faults()[1]),
            "4 underruns, servo enables dropped after 200.00 us, the controller reports watchdog after 210.00 us");
}

TEST(Injections, TheEndBelongsToTheFaultThatEnds) {
  InjectionMeter meter;
  meter.add(estop(0.2), {.tick = 0, .at = Cycles{100}});
  meter.add(estop(0.1), {.tick = 0, .at = Cycles{200}});
  meter.end(estop(0.1), Cycles{5'000'200});
  EXPECT_FALSE(meter.faults()[0].ended) << "it began first and lasts longer";
  EXPECT_EQ(meter.faults()[1].ended, Cycles{5'000'200});
}

TEST(Injections, EqualFaultsThatOverlapBothEnd) {
  InjectionMeter meter;
  meter.add(estop(0.1), {.tick = 0, .at = Cycles{100}});
  meter.add(estop(0.1), {.tick = 0, .at = Cycles{100}});
  meter.end(estop(0.1), Cycles{5'000'100});
  meter.end(estop(0.1), Cycles{5'000'100});
  EXPECT_EQ(meter.faults()[0].ended, Cycles{5'000'100});
  EXPECT_EQ(meter.faults()[1].ended, Cycles{5'000'100});
}

TEST(Injections, AnInputIsAcceptedByTheLineOfAProgramThatWaitedForIt) {
  InjectionMeter meter;
  meter.add(input(3, true), {.tick = 0, .at = Cycles{1'000}});
  ProgramNoted note{.place = 12, .kind = ProgramNoted::Kind::kWaits, .inputs = 0b100};
  meter.add(note, Cycles{1'050});
  EXPECT_FALSE(meter.inputs()[0].accepted());
  note.kind = ProgramNoted::Kind::kWaited;
  note.inputs = 0b1010;  // pins 2 and 4
  meter.add(note, Cycles{1'060});
  EXPECT_FALSE(meter.inputs()[0].accepted());
  note.inputs = 0b100;
  note.set_text("its time is over");
  meter.add(note, Cycles{1'070});
  EXPECT_FALSE(meter.inputs()[0].accepted());
  note.set_text("");
  meter.add(note, Cycles{1'100});
  EXPECT_EQ(answer_text(meter.inputs()[0], {}), "line 12 accepted it after 2.00 us");
}

TEST(Injections, AnInputIsAcceptedByTheWaitThatSawIt) {
  InjectionMeter meter;
  meter.add(wait_din(4));
  meter.add(wait_din(6));
  meter.add(input(3, true), {.tick = 0, .at = Cycles{1'000}});
  meter.add(IoDone{.tag = 9, .pin = 3, .level = true}, Cycles{1'050});  // a dout of output 3
  EXPECT_FALSE(meter.inputs()[0].accepted_by);
  meter.add(IoDone{.tag = 4, .pin = 2, .level = true}, Cycles{1'060});
  EXPECT_FALSE(meter.inputs()[0].accepted_by);
  meter.add(IoDone{.tag = 4, .pin = 3, .level = true}, Cycles{1'100});
  EXPECT_EQ(meter.inputs()[0].accepted_by, 4U);
  EXPECT_EQ(answer_text(meter.inputs()[0], {}), "move[4] accepted it after 2.00 us");
  meter.add(IoDone{.tag = 6, .pin = 3, .level = true}, Cycles{9'000});
  EXPECT_EQ(meter.inputs()[0].accepted_by, 4U) << "the first one counts";

  meter.add(input(3, false), {.tick = 3, .at = Cycles{10'000}});
  meter.add(IoDone{.tag = 6, .pin = 3, .level = true}, Cycles{10'010});  // what it saw was the level before
  EXPECT_EQ(answer_text(meter.inputs()[1], {}), "no move waited for it");
}

TEST(Injections, PulsesThatNeverComeAreNotLost) {
  InjectionMeter meter;
  meter.add(pulse_loss(1, 500), {.tick = 5'999, .at = Cycles{15'000'000}});
  TraceRow row;
  row.pulses_to_drop[0] = 500;
  row.telemetry.correction[0] = Pulses{-3};
  meter.add(row);
  EXPECT_EQ(moment_text(meter.faults()[0].when), "0.300000 s (tick 5999, cycle 15000000)");
  EXPECT_EQ(answer_text(meter.faults()[0]),
            "0 of 500 pulses lost, corrected by up to 3 pulses, the controller reports no fault");
}

// Servo enables are high before the fault.
InjectionMeter enabled_meter(const FaultSpec& fault) {
  InjectionMeter meter;
  meter.servo_enables(0x3F, Cycles{10});
  meter.add(fault, {.tick = 1, .at = Cycles{1'000}});
  return meter;
}

TEST(Injections, OnlyADropOfAllServoEnablesAnswersAnEmergencyStop) {
  InjectionMeter meter = enabled_meter(estop(0.02));
  meter.add(FaultEvent{.cause = FaultCause::kEstop, .where = {}});
  meter.add(BusAbortEvent{});
  TraceRow row;
  row.telemetry.underruns = 1;
  meter.add(row);
  meter.servo_enables(0x01, Cycles{2'000});
  EXPECT_FALSE(meter.faults()[0].answered);
  meter.servo_enables(0, Cycles{2'001});
  EXPECT_TRUE(meter.faults()[0].answered);
}

TEST(Injections, AnyResponseAnswersAnotherFault) {
  const FaultSpec hang{.at_s = 0, .kind = BlockHang{}};
  EXPECT_FALSE(enabled_meter(hang).faults()[0].answered);

  InjectionMeter meter = enabled_meter(hang);
  meter.add(FaultEvent{.cause = FaultCause::kEncoder, .where = {}});
  EXPECT_TRUE(meter.faults()[0].answered);

  meter = enabled_meter(hang);
  meter.add(BusAbortEvent{});
  EXPECT_TRUE(meter.faults()[0].answered);

  meter = enabled_meter(hang);
  meter.servo_enables(0x1F, Cycles{2'000});
  EXPECT_TRUE(meter.faults()[0].answered);

  meter = enabled_meter(hang);
  TraceRow row;
  row.telemetry.correction[2] = Pulses{5};  // of no lost pulse
  meter.add(row);
  EXPECT_FALSE(meter.faults()[0].answered);
  row.telemetry.underruns = 1;
  meter.add(row);
  EXPECT_TRUE(meter.faults()[0].answered);

  meter = enabled_meter(pulse_loss(3, 1));
  row.telemetry.underruns = 0;
  meter.add(row);
  EXPECT_TRUE(meter.faults()[0].answered);
}

TEST(Injections, AFaultOfAnArmWithoutPowerNeedsNoResponse) {
  InjectionMeter meter;
  meter.add(estop(0.02), {.tick = 1, .at = Cycles{1'000}});
  EXPECT_TRUE(meter.faults()[0].answered);
}

}  // namespace
}  // namespace armature::cosim
