// The rows of scenarios/FAULTS.md: who detects a fault, how soon, what the arm does and what the operator reads.
//
// They are measured: each row is made from runs with the fault at three times of one move.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim::test {

struct FaultCase {
  std::string_view fault{};  // the keys of the table [[fault]] but at_s; empty: `more` is the fault
  std::string_view more{};   // further keys of the scenario
  std::string_view why{};    // nobody detects it, or something else that the table must explain
  std::string_view robot = "vo2021_6r";
  std::string_view engine = "model";
  bool firmware = false;  // the cores execute its instructions
};

// Of a scenario whose cores execute the instructions of the firmware.
inline constexpr std::string_view kFirmwareKeys = "[cpu]\nprocessor = \"a9\"\ncpi = 1.5";
inline constexpr std::array kFaultTimes{0.2001, 0.22619, 0.26003};

[[nodiscard]] Scenario scenario_of(const FaultCase& row, double at_s);

// A table with its notes. A fault that nobody detects needs a sentence; a servo that is on again without a reset, and a
// false position of an axis that is referenced, fail.
[[nodiscard]] std::string table_of(const std::vector<FaultCase>& rows);

// The text of FAULTS.md.
[[nodiscard]] std::string committed_rows();
// Compares a part of FAULTS.md, from this title up to the next one of its rank or the end, with what was measured. With
// ARMATURE_WRITE_FAULTS = FILE, writes the part into this file.
void expect_committed(std::string_view title, const std::string& measured);

}  // namespace armature::cosim::test
