// scenarios/FAULTS.md: who detects each kind of fault, how soon, what the arm does and what the operator reads.
//
// The table is measured: each row is made from runs on the model engine (flops: on the RTL), with the fault at three
// times of one move. A fault that nobody detects, or that is detected later or by another one than the committed table
// says, fails.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "controller/base/timebase.hpp"
#include "cosim/report/format/injection_text.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/scenario/kinds.hpp"
#include "cosim/text/names.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim {
namespace {

using test::FaultCase;
using test::scenario_of;
using RunUnderTest = Run;  // Test has a function Run

constexpr std::string_view kNoSerial =
    "The arm does not need the serial line. The frames of the pendant have checksums, and its silence stops the arm.";

// A kind may have several rows.
const std::vector<FaultCase> kCases{
    {.fault = R"(kind = "pulse_loss", axis = 3, count = 50)"},
    {.fault = R"(kind = "pulse_loss", axis = 3, count = 5000)"},
    {.fault = R"(kind = "extra_pulses", axis = 3, count = 50)"},
    {.fault = R"(kind = "drive_alarm", axis = 2, duration_s = 0.02)"},
    {.fault = R"(kind = "axis_blocked", axis = 2, duration_s = 1)"},
    {.fault = R"(kind = "encoder_stuck", axis = 1, line = "a", level = 0, duration_s = 1)"},
    {.fault = R"(kind = "encoder_stuck", axis = 1, line = "b", level = 1, duration_s = 1)"},
    {.fault = R"(kind = "encoder_stuck", axis = 1, line = "z", level = 0, duration_s = 1)",
     .why = "The arm needs the index for homing only. A missing index is no mismatch."},
    {.fault = R"(kind = "encoder_cable", axis = 1, duration_s = 1)"},
    {.fault = R"(kind = "encoder_swapped", axis = 1, duration_s = 1)"},
    {.fault = R"(kind = "encoder_chatter", axis = 1, line = "a", period_us = 10, duration_s = 1)"},
    {.fault = R"(kind = "encoder_chatter", axis = 1, line = "a", period_us = 0.04, duration_s = 1)"},
    {.fault = R"(kind = "encoder_noise", axis = 1, line = "b", width_us = 0.02, mean_gap_us = 20, duration_s = 1)",
     .why = "The filter of the decoder takes glitches away that are shorter than its debounce time."},
    {.fault = R"(kind = "encoder_noise", axis = 1, line = "b", width_us = 1, mean_gap_us = 20, duration_s = 1)"},
    {.fault = R"(kind = "encoder_miscount", axis = 1, counts = 40)"},
    {.fault = R"(kind = "index_slip", axis = 1, counts = 400)"},
    {.more = "moved_start_deg = [0, 0, 2, 0, 0, 0]"},
    {.fault = R"(kind = "switch_stuck", axis = 4, switch = "limit_pos", level = 1, duration_s = 1)"},
    {.fault = R"(kind = "switch_stuck", axis = 4, switch = "limit_neg", level = 1, duration_s = 1)",
     .why = "The axis moves away from this switch, which is allowed. The next motion towards it is a fault."},
    {.fault = R"(kind = "switch_stuck", axis = 4, switch = "home", level = 1, duration_s = 1)",
     .why = "Only homing looks at the home switch."},
    {.fault = R"(kind = "switch_bounce", axis = 4, switch = "limit_pos", period_us = 500, duration_s = 1)"},
    {.fault = R"(kind = "slow_core", compute_us = 60)"},
    {.fault = R"(kind = "slow_core", compute_us = 1000000)"},
    {.fault = R"(kind = "core1_stuck")"},
    {.fault = R"(kind = "interrupt_lost", duration_s = 0.00004)",
     .why = "The interrupt is late by less than the slack of a tick: the counts still come in time."},
    {.fault = R"(kind = "interrupt_lost", duration_s = 1)"},
    {.fault = R"(kind = "estop", duration_s = 0.01)"},
    {.fault = R"(kind = "clock_stop", duration_s = 0.0002)"},
    {.fault = R"(kind = "stray_write", address = 0x42800000, data = 0)"},
    {.fault = R"(kind = "register_flip", address = 0x42800000, bit = 7)"},
    {.fault = R"(kind = "stray_write", address = 0x43C10004, data = 0x100)"},  // the servo enables of all axes
    {.fault = R"(kind = "register_flip", address = 0x43C10004, bit = 3)"},
    {.fault = R"(kind = "block_hang", clock = "io")",
     .why =
         "The arm needs neither the outputs of the tool nor the serial line. The first access to them stops core 1."},
    {.fault = R"(kind = "block_hang", clock = "motion")",
     .why = "The watchdog and the servo enables stand still with the block. Only the relay of `drop_out_us` takes the "
            "power away. A run without it never passes."},
    {.fault = R"(kind = "block_hang", clock = "motion")", .more = "drop_out_us = 500"},
    {.fault = R"(kind = "block_hang", clock = "encoder")",
     .why = "Also when the clock stops during a response: the crossbar refuses one that nobody asked for."},
    {.fault = R"(kind = "slave_error", address = 0x43C10008, count = 1)"},
    {.fault = R"(kind = "slow_slave", delay_us = 0.2, duration_s = 1)", .why = "Core 0 has the time."},
    {.fault = R"(kind = "slow_slave", delay_us = 5, duration_s = 1)"},
    {.fault = R"(kind = "brake_slip", axis = 2, share = 0, duration_s = 1)",
     .why = "The brake is open while the servo is on. It matters when the servo is off.",
     .robot = "vo2021_6r_dynamic"},
    {.fault = R"(kind = "collision_torque", axis = 2, torque_nm = 100, duration_s = 1)",
     .why = "The drive of the axis holds against it.",
     .robot = "vo2021_6r_dynamic"},
    {.fault = R"(kind = "collision_torque", axis = 2, torque_nm = -2000, duration_s = 1)",
     .robot = "vo2021_6r_dynamic"},
    {.fault = R"(kind = "uart_break", duration_s = 0.01)", .why = kNoSerial},
    {.fault = R"(kind = "uart_noise", width_us = 5, mean_gap_us = 50, duration_s = 1)", .why = kNoSerial},
    {.fault = R"(kind = "uart_overrun", duration_s = 0.1)", .why = kNoSerial},
    {.fault = R"(kind = "flop_flip", flop = "servo_on_o", bit = 1)", .engine = "rtl"},
    {.fault = R"(kind = "flop_flip", flop = "u_axi_timer.u_core.u_timer0.tlr_o", bit = 15)", .engine = "rtl"},
    {.fault = R"(kind = "flop_flip", flop = "u_axi_timer.u_core.u_timer0.tlr_o", bit = 10)", .engine = "rtl"},
};
const std::string kIntroduction =
    "\n"
    "Written by `tests/cosim/fault/fault_table_test.cpp`: `ARMATURE_WRITE_FAULTS=FILE` writes a new one. Each row "
    "is\n"
    "the worst of three runs, with the fault at three times of a joint move of six axes. A tick is 50 us.\n\n"
    "- **Detected by**: the logic, the drive, the motion loop of core 0, the bus (a core gets an error response), "
    "or\n"
    "  nobody. The number is the ticks from the begin of the fault to the report.\n"
    "- **Arm**: `stop 0` takes the servo power away at once, `stop 1` brakes on the path before. The number is the\n"
    "  ticks until all servo enables are low.\n"
    "- **Encoder**: whether the controller ends the run with the counts of the motors, to two ticks of motion.\n"
    "  `unknown`: the controller does not speak any more.\n"
    "- **Reset**: of the arm after a stop, by `clear_fault` at 0.62 s. `true`: each axis is referenced, and its\n"
    "  position is right. `unhomed`: an axis is not referenced any more, and does not move before it is homed.\n"
    "  `no motion`: the reset is refused, the fault is back at once, or nobody is there to execute it.\n\n";

TEST(FaultTable, EveryKindHasARow) {
  const std::string committed = test::committed_rows();
  const auto has = [&](const std::string& begin) { return committed.find(begin) != std::string::npos; };
  for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
    const std::string row = fmt::format("\n| {}", fault_kind_name(Kind{}));
    EXPECT_TRUE(has(row + ' ') || has(row + ',')) << fault_kind_name(Kind{});
  });
}

// The pins of both engines are compared after each clock edge, and the rows of the trace with those of whole ticks.
TEST(FaultTable, EveryFaultIsTheSameOnAllEngines) {
  class Rows final : public RunListener {
   public:
    void on_row(const TraceRow& row, const IntegerDigest&) override {
      rows.push_back({row.cycle, row.telemetry.encoder, row.motor_to});
    }
    std::vector<std::tuple<std::int64_t, PerAxis<Counts>, PerAxis<std::int64_t>>> rows;
  };
  for (const FaultCase& row : kCases) {
    if (row.engine != FaultCase{}.engine) continue;
    const auto rows_of = [&](Engine engine) {
      Scenario scenario = scenario_of(row, 0.01603);
      scenario.engine = engine;
      scenario.duration_s = 0.02;
      RunUnderTest run{scenario};
      Rows rows;
      run.add(rows);
      test::run_out(run);
      EXPECT_EQ(run.finish().failure, std::nullopt) << row.fault;
      return rows.rows;
    };
    EXPECT_EQ(rows_of(Engine::kLockstep), rows_of(Engine::kModel)) << row.fault;
  }
}

TEST(FaultTable, TheCommittedTableIsWhatTheRunsShow) {
  test::expect_committed("# Faults: who detects them\n", kIntroduction + test::table_of(kCases));
}

}  // namespace
}  // namespace armature::cosim
