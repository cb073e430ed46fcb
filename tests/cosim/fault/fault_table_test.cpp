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

using RunUnderTest = Run;

struct Case {
  std::string_view fault;   // the keys of the table [[fault]] but at_s
  std::string_view more{};  // further keys of the scenario
  std::string_view why{};   // nobody detects it, or something else that the table must explain
  std::string_view robot = "vo2021_6r";
  std::string_view engine = "model";
};

constexpr std::int64_t kTwoTicks = 20;  // of motion [counts]: the controller knows the encoders of the latest trigger

constexpr std::string_view kNoSerial =
    "The arm does not need the serial line. The frames of the pendant have checksums, and its silence stops the arm.";

// A kind may have several rows.
const std::vector<Case> kCases{
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
    {.fault = R"(kind = "uart_break", duration_s = 0.01)", .why = kNoSerial},
    {.fault = R"(kind = "uart_noise", width_us = 5, mean_gap_us = 50, duration_s = 1)", .why = kNoSerial},
    {.fault = R"(kind = "uart_overrun", duration_s = 0.1)", .why = kNoSerial},
    {.fault = R"(kind = "flop_flip", flop = "servo_on_o", bit = 1)", .engine = "rtl"},
    {.fault = R"(kind = "flop_flip", flop = "u_axi_timer.u_core.u_timer0.tlr_o", bit = 15)", .engine = "rtl"},
    {.fault = R"(kind = "flop_flip", flop = "u_axi_timer.u_core.u_timer0.tlr_o", bit = 10)", .engine = "rtl"},
};
constexpr double kResetAt = 0.62;
constexpr std::array kTimes{0.2001, 0.22619, 0.26003};

Scenario scenario_of(const Case& row, double at_s) {
  std::string fault;
  for (std::size_t begin = 0; begin < row.fault.size();) {
    const std::size_t end = std::min(row.fault.find(", ", begin), row.fault.size());
    fault += std::string{row.fault.substr(begin, end - begin)} + '\n';
    begin = end + 2;
  }
  const test::TempFolder folder;
  const std::string text = fmt::format(R"(description = "fault"
robot = "{}"
duration_s = 0.65
engine = "{}"
seed = 3
{}
[[move]]
at_s = 0.01
type = "joint"
target_deg = [40, 40, 40, 40, 40, 40]
[[move]]
at_s = {}
type = "clear_fault"
[[fault]]
at_s = {}
)",
                                       row.robot, row.engine, row.more, kResetAt, at_s) +
                           fault;
  return load_scenario(folder.write("s/scenario.toml", text), test::shipped());
}

// What happens after the fault.
class Watch final : public RunListener {
 public:
  void on_action(const ScriptAction& action, const RunPlace& place) override {
    if (std::holds_alternative<FaultSpec>(action)) begun_ = place;
  }
  void on_row(const TraceRow& row, const IntegerDigest&) override {
    if (!begun_) return;
    if (row.telemetry.underruns != 0 && !underrun) underrun = Cycles{row.cycle};
    const auto corrects = [](Pulses pulses) { return pulses != Pulses{}; };
    if (std::ranges::any_of(row.telemetry.correction, corrects) && !correction) correction = Cycles{row.cycle};
    if (row.telemetry.state == MotionState::kStopping && !servo_off) stopping = true;
    last = row.telemetry;
    if (reset && !pulses_at_reset) pulses_at_reset = row.pin_pulses;
    if (pulses_at_reset && row.pin_pulses != *pulses_at_reset) moved_after_reset = true;
  }
  void on_event(const Event& event, const RunPlace&) override {
    if (std::holds_alternative<FaultCleared>(event)) reset = true;
  }
  void on_signal(const Signal& signal, const RunPlace& place) override {
    const auto* servos = std::get_if<ServoEnables>(&signal);
    if (servos != nullptr && servos->levels == 0 && begun_ && !servo_off) servo_off = place.at;
    if (servos != nullptr && servos->levels != 0 && servo_off && place.at < Cycles{31'000'000}) on_without_reset = true;
  }

  std::optional<Cycles> underrun, correction, servo_off;
  bool stopping = false;
  Telemetry last;
  bool reset = false;
  bool on_without_reset = false, moved_after_reset = false;
  std::optional<PerAxis<std::int64_t>> pulses_at_reset;
  [[nodiscard]] Cycles begun() const { return begun_->at; }

 private:
  std::optional<RunPlace> begun_;
};

// One run, in the words of the table.
struct Seen {
  std::string by = "nobody", stop = "continues", text = "nothing", lost = "right", reset;
  std::optional<std::int64_t> ticks, servo_off_ticks;
};

std::string detector_of(FaultCause cause) {
  switch (cause) {
    case FaultCause::kDriveAlarm:
      return "drive";
    case FaultCause::kEstop:
    case FaultCause::kWatchdog:
    case FaultCause::kEncoder:
      return "logic";
    default:
      return "motion loop";
  }
}

// `the controller reports estop` of a longer text.
std::string report_in(const std::string& text) {
  const std::size_t begin = text.rfind("the controller reports"), end = text.rfind(" after ");
  return text.substr(begin, end - begin);
}

// Nothing moves without a reset. Then the position is true, or the axis is not referenced.
std::string after_reset(const Case& row, const Watch& watch, const Seen& seen) {
  EXPECT_FALSE(watch.on_without_reset) << row.fault << ": a servo was on again before the reset";
  if (!watch.servo_off) return "";
  if (!watch.reset || watch.last.state == MotionState::kFault) return "no motion";
  EXPECT_FALSE(watch.moved_after_reset) << row.fault << ": the arm moved without a command";
  constexpr std::uint8_t kAll = 0x3F;
  if ((watch.last.referenced & kAll) != kAll) return "unhomed";
  EXPECT_EQ(seen.lost, "right") << row.fault << ": the position is false, and the axis is referenced";
  return "true";
}

Seen see(const Case& row, double at_s) {
  const Scenario scenario = scenario_of(row, at_s);
  RunUnderTest run{scenario};
  Watch watch;
  run.add(watch);
  test::run_out(run);
  const RunSummary summary = run.finish();
  const RunFacts& facts = summary.facts;
  Seen seen;
  if (summary.failure) {
    ADD_FAILURE() << row.fault << " at " << at_s << " s: " << *summary.failure;
    return seen;
  }
  const auto since = [&](Cycles at) {
    return ((at - watch.begun()).value() + kTickCycles.value() - 1) / kTickCycles.value();
  };
  if (!facts.bus_aborts.empty()) {
    seen.by = "bus";
    seen.text = abort_text(facts.bus_aborts.front());
    seen.ticks = since(facts.bus_aborts.front().where.at);
  } else if (!facts.faults.empty()) {
    const FaultEvent& fault = facts.faults.front();
    seen.by = detector_of(fault.cause);
    seen.text = report_in(answer_text(facts.injected_faults.front()));
    seen.ticks = since(fault.where.at);
  } else if (watch.servo_off) {
    seen.by = "logic";
    seen.ticks = since(*watch.servo_off);
    seen.text = "outcome fault:controller_silent";
  } else if (watch.underrun) {
    seen.by = "logic";
    seen.ticks = since(*watch.underrun);
    seen.text = "the number of underruns";
  } else if (watch.correction && row.robot == Case{}.robot) {  // the dynamic plant always needs corrections
    seen.by = "motion loop";
    seen.ticks = since(*watch.correction);
    seen.text = "the correction of the axis";
  }
  if (watch.servo_off) {
    seen.servo_off_ticks = since(*watch.servo_off);
    seen.stop = watch.stopping ? "stop 1" : "stop 0";
  }
  const auto is_lost = [](std::int64_t counts) { return std::abs(counts) > kTwoTicks; };
  if (std::ranges::any_of(facts.lost_counts, is_lost)) seen.lost = "wrong";
  if (facts.controller_silent) seen.lost = "unknown";
  seen.reset = after_reset(row, watch, seen);
  return seen;
}

template <class Member>
std::string all_of(const std::array<Seen, kTimes.size()>& runs, Member member) {
  std::vector<std::string> texts;
  for (const Seen& seen : runs) {
    if (std::ranges::find(texts, seen.*member) == texts.end()) texts.push_back(seen.*member);
  }
  return fmt::format("{}", fmt::join(texts, ", or "));
}

template <class Member>
std::string worst_of(const std::array<Seen, kTimes.size()>& runs, Member member) {
  std::optional<std::int64_t> worst;
  for (const Seen& seen : runs) {
    if (seen.*member) worst = std::max(worst.value_or(0), *(seen.*member));
  }
  return worst ? std::to_string(*worst) : "";
}

std::string table() {
  std::string text =
      "# Faults: who detects them\n\n"
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
      "  `no motion`: the reset is refused, the fault is back at once, or nobody is there to execute it.\n\n"
      "| fault | detected by | ticks | arm | ticks | encoder | reset | the operator reads |\n"
      "|---|---|---:|---|---:|---|---|---|\n";
  std::string notes;
  int number = 0;
  for (const Case& row : kCases) {
    std::array<Seen, kTimes.size()> runs;
    std::ranges::transform(kTimes, runs.begin(), [&](double at_s) { return see(row, at_s); });
    const std::string by = all_of(runs, &Seen::by);
    EXPECT_TRUE(by != "nobody" || !row.why.empty()) << row.fault << ": nobody detects it, and no sentence says why";
    std::string name = fault_text(scenario_of(row, kTimes[0]).faults.front());
    if (!row.more.empty()) name += fmt::format(", with `{}`", row.more);
    if (!row.why.empty()) {
      name += fmt::format(" ({})", ++number);
      notes += fmt::format("{}. {}\n", number, row.why);
    }
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", name, by, worst_of(runs, &Seen::ticks),
                        all_of(runs, &Seen::stop), worst_of(runs, &Seen::servo_off_ticks), all_of(runs, &Seen::lost),
                        all_of(runs, &Seen::reset), all_of(runs, &Seen::text));
  }
  return text + "\n" + notes;
}

TEST(FaultTable, EveryKindHasARow) {
  std::set<std::string_view> rows;
  for (const Case& row : kCases) rows.insert(fault_kind_name(scenario_of(row, 0.1).faults.front().kind));
  for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
    EXPECT_TRUE(rows.contains(fault_kind_name(Kind{}))) << fault_kind_name(Kind{});
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
  for (const Case& row : kCases) {
    if (row.engine != Case{}.engine) continue;
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
  const std::string measured = table();
  if (const char* file = std::getenv("ARMATURE_WRITE_FAULTS")) std::ofstream{file} << measured;
  std::ifstream file{std::string{ARMATURE_SOURCE_DIR} + "/scenarios/FAULTS.md"};
  const std::string committed{std::istreambuf_iterator<char>{file}, {}};
  EXPECT_EQ(committed, measured);
}

}  // namespace
}  // namespace armature::cosim
