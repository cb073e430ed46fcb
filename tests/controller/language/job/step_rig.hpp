// One instruction with its operands, as the parts of the machine get them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "controller/language/job/state/operand_reader.hpp"
#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::test {

// The instruction is in line 15 of a job with the positions C0 to C4; the port is at kPlace.
struct StepRig {
  static constexpr ProgramPlace kPlace = 15;

  explicit StepRig(const std::string& instruction) {
    EXPECT_TRUE(jobs.load(moving_job_of(instruction + "\n"))) << jobs.said.errors.front();
    variables.reset();
  }

  void set(job::VariableType type, int number, double value) {
    EXPECT_EQ(variables.store({type, false, static_cast<double>(number)}, value), job::Alarm::kNone);
  }

  Jobs jobs{};
  RecordingPort port{};
  job::Variables variables{};
  job::PinLevels levels{};
  // The record behind NOP.
  job::Step step{port, jobs.memory->records_of(jobs.memory->jobs[0]), 1, kPlace};
};

// The same with a reader of its operands.
struct ReaderRig : StepRig {
  using StepRig::StepRig;
  job::OperandReader operands{*jobs.memory, variables, levels, step};

  // The value behind the first operand, which is a variable.
  double value() {
    double value = -1.0;
    operands.skip();
    EXPECT_TRUE(operands.number(value));
    return value;
  }
};

}  // namespace armature::test
