#include "tests/cosim/fault/fault_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>

#include "controller/base/timebase.hpp"
#include "cosim/report/format/injection_text.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/text/names.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/whole_run.hpp"

namespace armature::cosim::test {
namespace {

constexpr std::int64_t kTwoTicks = 20;  // of motion [counts]: the controller knows the encoders of the latest trigger

constexpr double kResetAt = 0.62;

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
  // The fault is there from the first tick on.
  void begin() { begun_.emplace(); }
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
std::string after_reset(const FaultCase& row, const Watch& watch, const Seen& seen) {
  EXPECT_FALSE(watch.on_without_reset) << row.fault << ": a servo was on again before the reset";
  if (!watch.servo_off) return "";
  if (!watch.reset || watch.last.state == MotionState::kFault) return "no motion";
  EXPECT_FALSE(watch.moved_after_reset) << row.fault << ": the arm moved without a command";
  constexpr std::uint8_t kAll = 0x3F;
  if ((watch.last.referenced & kAll) != kAll) return "unhomed";
  EXPECT_EQ(seen.lost, "right") << row.fault << ": the position is false, and the axis is referenced";
  return "true";
}

Seen see(const FaultCase& row, double at_s) {
  const Scenario scenario = scenario_of(row, at_s);
  Run run{scenario};
  Watch watch;
  if (row.fault.empty()) watch.begin();
  run.add(watch);
  run_out(run);
  const RunSummary summary = run.finish();
  const RunFacts& facts = summary.facts;
  Seen seen;
  if (summary.failure) {
    ADD_FAILURE() << row.fault << " at " << at_s << " s: " << *summary.failure;
    return seen;
  }
  const auto since = [&](Cycles at) {
    return ((at - watch.begun()).value() + armature::kTickCycles.value() - 1) / armature::kTickCycles.value();
  };
  if (!facts.bus_aborts.empty()) {
    seen.by = "bus";
    seen.text = abort_text(facts.bus_aborts.front());
    seen.ticks = since(facts.bus_aborts.front().where.at);
  } else if (!facts.faults.empty()) {
    const FaultEvent& fault = facts.faults.front();
    seen.by = detector_of(fault.cause);
    seen.text = facts.injected_faults.empty()
                    ? fmt::format("the controller reports {} of axis {}", word_of(fault.cause), fault.where.axis)
                    : report_in(answer_text(facts.injected_faults.front()));
    seen.ticks = since(fault.where.at);
  } else if (watch.servo_off) {
    seen.by = "logic";
    seen.ticks = since(*watch.servo_off);
    seen.text = "outcome fault:controller_silent";
  } else if (watch.underrun) {
    seen.by = "logic";
    seen.ticks = since(*watch.underrun);
    seen.text = "the number of underruns";
  } else if (watch.correction && row.robot == FaultCase{}.robot) {  // the dynamic plant always needs corrections
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
std::string all_of(const std::array<Seen, kFaultTimes.size()>& runs, Member member) {
  std::vector<std::string> texts;
  for (const Seen& seen : runs) {
    if (std::ranges::find(texts, seen.*member) == texts.end()) texts.push_back(seen.*member);
  }
  return fmt::format("{}", fmt::join(texts, ", or "));
}

template <class Member>
std::string worst_of(const std::array<Seen, kFaultTimes.size()>& runs, Member member) {
  std::optional<std::int64_t> worst;
  for (const Seen& seen : runs) {
    if (seen.*member) worst = std::max(worst.value_or(0), *(seen.*member));
  }
  return worst ? std::to_string(*worst) : "";
}

std::string name_of(const FaultCase& row) {
  if (row.fault.empty()) return fmt::format("`{}`", row.more);
  const std::string name = fault_text(scenario_of(row, kFaultTimes[0]).faults.front());
  return row.more.empty() ? name : fmt::format("{}, with `{}`", name, row.more);
}

std::string text_of_file(const std::string& name) {
  std::ifstream file{name};
  return {std::istreambuf_iterator<char>{file}, {}};
}

// From the title up to the next title of the first or second rank.
std::size_t end_of_part(const std::string& text, std::size_t begin) {
  return std::min({text.size(), text.find("\n# ", begin), text.find("\n## ", begin)});
}

}  // namespace

Scenario scenario_of(const FaultCase& row, double at_s) {
  std::string fault = row.fault.empty() ? std::string{} : fmt::format("[[fault]]\nat_s = {}\n", at_s);
  for (std::size_t begin = 0; begin < row.fault.size();) {
    const std::size_t end = std::min(row.fault.find(", ", begin), row.fault.size());
    fault += std::string{row.fault.substr(begin, end - begin)} + '\n';
    begin = end + 2;
  }
  const TempFolder folder;
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
)",
                                       row.robot, row.engine, row.firmware ? kFirmwareKeys : row.more, kResetAt) +
                           fault;
  return load_scenario(folder.write("s/scenario.toml", text), shipped());
}

std::string table_of(const std::vector<FaultCase>& rows) {
  std::string text =
      "| fault | detected by | ticks | arm | ticks | encoder | reset | the operator reads |\n"
      "|---|---|---:|---|---:|---|---|---|\n";
  std::string notes;
  int number = 0;
  for (const FaultCase& row : rows) {
    std::array<Seen, kFaultTimes.size()> runs;
    std::ranges::transform(kFaultTimes, runs.begin(), [&](double at_s) { return see(row, at_s); });
    const std::string by = all_of(runs, &Seen::by);
    EXPECT_TRUE(by != "nobody" || !row.why.empty()) << row.fault << ": nobody detects it, and no sentence says why";
    std::string name = name_of(row);
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

std::string committed_rows() {
  return text_of_file(std::string{ARMATURE_SOURCE_DIR} + "/scenarios/FAULTS.md");
}

void expect_committed(std::string_view title, const std::string& measured) {
  const std::string committed = committed_rows();
  const std::size_t begin = std::min(committed.find(title), committed.size());
  EXPECT_EQ(committed.substr(begin, end_of_part(committed, begin) - begin), std::string{title} + measured);
  if (const char* file = std::getenv("ARMATURE_WRITE_FAULTS")) {
    std::string text = text_of_file(file);
    const std::size_t from = std::min(text.find(title), text.size());
    text.replace(from, end_of_part(text, from) - from, std::string{title} + measured);
    std::ofstream{file} << text;
  }
}

}  // namespace armature::cosim::test
