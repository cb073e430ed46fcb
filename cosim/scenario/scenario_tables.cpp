#include "cosim/scenario/scenario_tables.hpp"

#include <algorithm>
#include <string>

#include "controller/command/command.hpp"
#include "controller/core/timebase.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxDurationS = 86'400;   // a day
constexpr double kMaxCycles = 50'000'000;  // a second of the 50 MHz clock
constexpr double kMaxStretch = 1000;
constexpr double kMaxCount = 1'000'000'000;

void read_controller(TableReader& table, bool paper, ControllerSpec& controller) {
  table.read("sync", controller.sync, one_of({"fig9", "const_acc", "time_scale"}));
  table.read("feedback", controller.feedback, anything());
  if (paper && table.has("feedback") && controller.feedback) {
    table.problem("feedback", "expected false with variant = \"paper\", whose decoder sees one encoder, found true");
  }
  table.read("max_stretch", controller.max_stretch, between(1, kMaxStretch));
}

void read_cpu(TableReader& table, CpuSpec& cpu) {
  table.read("interrupt_entry_cycles", cpu.interrupt_entry_cycles, between(0, kMaxCycles, "cycles"));
  table.read("tick_compute_cycles", cpu.tick_compute_cycles, between(0, kMaxCycles, "cycles"));
  table.read("plan_compute_cycles", cpu.plan_compute_cycles, between(0, kMaxCycles, "cycles"));
  // At least one: planning that costs no simulated time could keep the host busy between two cycles.
  table.read("inverse_compute_cycles", cpu.inverse_compute_cycles, between(1, kMaxCycles, "cycles"));
}

void read_bus(TableReader& table, BusSpec& bus) {
  table.read("latency_cycles", bus.latency_cycles, between(0, 10'000, "cycles"));
  table.read("timeout_cycles", bus.timeout_cycles, between(10, kMaxCycles, "cycles"));
  table.read("stall_probability", bus.stall_probability, between(0, 0.9));
  if (bus.timeout_cycles <= 2 * bus.latency_cycles) {
    table.problem("timeout_cycles", "expected more than twice latency_cycles = " + std::to_string(bus.latency_cycles) +
                                        ", found " + std::to_string(bus.timeout_cycles));
  }
}

void read_fault(TableReader& table, double duration_s, FaultSpec& fault) {
  fault.line = table.line();
  read_at(table, duration_s, fault.at_s);
  std::string kind;
  if (!table.read("kind", kind, one_of(kFaultKindNames), Need::kRequired)) {
    table.ignore_rest();
    return;
  }
  if (kind == "pulse_loss") {
    fault.kind = FaultKind::kPulseLoss;
    std::int64_t axis = 0;
    table.read("axis", axis, between(1, kAxes), Need::kRequired);
    table.read("count", fault.count, between(1, kMaxCount, "pulses"), Need::kRequired);
    fault.axis = static_cast<int>(axis);
  } else {
    table.refuse({"axis", "count"}, "kind = \"pulse_loss\"");
  }
  if (kind == "slow_core") {
    fault.kind = FaultKind::kSlowCore;
    table.read("compute_us", fault.compute_us, above(0, 1'000'000, "us"), Need::kRequired);
  } else {
    table.refuse({"compute_us"}, "kind = \"slow_core\"");
  }
  if (kind == "estop") {
    fault.kind = FaultKind::kEstop;
    table.read("duration_s", fault.duration_s, above(0, kMaxDurationS, "s"), Need::kRequired);
  } else {
    table.refuse({"duration_s"}, "kind = \"estop\"");
  }
}

void read_trace(TableReader& table, const ScenarioRobot& robot, TraceSpec& trace) {
  table.read("every_ticks", trace.every_ticks, between(1, kMaxCount, "ticks"));
  table.read("tcp", trace.tcp, anything());
  if (trace.tcp == true && robot.lacks_kinematics()) {
    table.problem("tcp", "needs [kinematics] in " + robot.file);
  }
}

void read_frame(TableReader& table, std::vector<FrameSpec>& frames) {
  FrameSpec frame;
  if (table.read("name", frame.name, anything(), Need::kRequired)) {
    const bool taken = std::ranges::find(frames, frame.name, &FrameSpec::name) != frames.end();
    if (frame.name.empty() || frame.name == kBaseFrameName || frame.name == kToolFrameName) {
      table.problem("name",
                    "expected a name other than \"\", \"base\" and \"tool\", found \"" + printable(frame.name) + "\"");
    } else if (taken) {
      table.problem("name", "there is another frame \"" + printable(frame.name) + "\"");
    }
  }
  read_pose(table, frame.pose);
  frames.push_back(std::move(frame));
}

// Tool and frames serve poses only.
void read_places(TableReader& root, const ScenarioRobot& robot, Scenario& scenario) {
  root.table("tool", [&](TableReader& table) { read_pose(table, scenario.tool); });
  root.tables(
      "frame", [&](TableReader& table) { read_frame(table, scenario.frames); }, kUserFrames);
  for (const std::string_view key : {"tool", "frame"}) {
    if (root.has(key) && robot.lacks_kinematics()) root.problem(key, "needs [kinematics] in " + robot.file);
  }
}

void read_serial_tables(TableReader& root, Scenario& scenario) {
  root.table("serial", [&](TableReader& table) { read_serial(table, scenario.serial.emplace()); });
  root.tables("serial_send",
              [&](TableReader& table) { read_serial_send(table, scenario, scenario.serial_sends.emplace_back()); });
  if (root.has("serial_send") && !scenario.serial) root.problem("serial_send", "needs a table [serial]");
}

void read_golden(TableReader& table, GoldenSpec& golden) {
  constexpr std::size_t kDigits = 64;
  std::string digest;
  if (!table.read("sha256", digest, anything(), Need::kRequired)) return;
  if (digest.size() != kDigits || digest.find_first_not_of("0123456789abcdef") != std::string::npos) {
    table.problem("sha256", "expected 64 lower-case hexadecimal digits, found \"" + printable(digest) + "\"");
    return;
  }
  golden.sha256 = digest;
}

void read_paper(TableReader& table, const ScenarioRobot& robot, PaperSpec& paper) {
  const std::size_t axes = robot.axis_count() == 0 ? kAxes : robot.axis_count();
  table.read("encoder_axis", paper.encoder_axis, between(1, static_cast<double>(axes)));
  table.read("switch_every_ticks", paper.switch_every_ticks, between(2, kMaxCount, "ticks"));
  if (table.has("encoder_axis") && table.has("switch_every_ticks")) {
    table.problem("switch_every_ticks", "cannot stand beside encoder_axis, which is never switched");
  }
}

template <class Enum, std::size_t kCount>
void read_named(TableReader& table, std::string_view key, const std::array<std::string_view, kCount>& names,
                Enum& out) {
  std::string name;
  if (table.read(key, name, one_of(names))) out = *named<Enum>(names, name);
}

// Returns whether keys about the variant of the paper are allowed.
bool read_logic(TableReader& root, const ScenarioRobot& robot, const LogicChoice& chosen, Scenario& scenario) {
  Variant written = Variant::kCounts;
  read_named(root, "variant", kVariantNames, written);
  scenario.variant = chosen.variant.value_or(written);
  read_named(root, "engine", kEngineNames, scenario.engine);
  scenario.engine = chosen.engine.value_or(scenario.engine);
  root.table("paper", [&](TableReader& table) { read_paper(table, robot, scenario.paper); });
  const bool allowed = scenario.variant == Variant::kPaper || written == Variant::kPaper;
  if (root.has("paper") && !allowed) root.problem("paper", "has no effect without variant = \"paper\"");
  return allowed;
}

template <class Spec>
void sort_by_time(std::vector<Spec>& specs) {
  std::stable_sort(specs.begin(), specs.end(), [](const Spec& a, const Spec& b) { return a.at_s < b.at_s; });
}

}  // namespace

void read_at(TableReader& table, double duration_s, double& at_s) {
  if (!table.read("at_s", at_s, between(0, kMaxDurationS, "s"), Need::kRequired)) return;
  if (duration_s > 0 && at_s >= duration_s) {
    table.problem("at_s",
                  "expected less than duration_s = " + number_text(duration_s) + ", found " + number_text(at_s));
  }
}

void read_pose(TableReader& table, PoseSpec& pose) {
  table.read("xyz_mm", pose.xyz_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"));
  table.read("rpy_deg", pose.rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"));
}

void read_identity(TableReader& root, Scenario& scenario) {
  root.read("description", scenario.description, anything(), Need::kRequired);
  root.read("robot", scenario.robot_name, anything(), Need::kRequired);
}

void read_scenario(TableReader& root, const ScenarioRobot& robot, const LogicChoice& chosen, Scenario& scenario) {
  if (root.read("duration_s", scenario.duration_s, above(0, kMaxDurationS, "s"), Need::kRequired) &&
      scenario.duration_s < kTickSeconds) {
    root.problem("duration_s", "expected at least " + number_text(kTickSeconds) +
                                   " (s), one tick of the controller, found " + number_text(scenario.duration_s));
  }
  root.read("seed", scenario.seed, at_least(0));
  const bool paper_keys = read_logic(root, robot, chosen, scenario);
  const bool paper = scenario.variant == Variant::kPaper;
  root.table("controller", [&](TableReader& table) { read_controller(table, paper, scenario.controller); });
  if (paper) scenario.controller.feedback = false;
  root.table("cpu", [&](TableReader& table) { read_cpu(table, scenario.cpu); });
  root.table("bus", [&](TableReader& table) { read_bus(table, scenario.bus); });
  root.table("trace", [&](TableReader& table) { read_trace(table, robot, scenario.trace); });
  read_places(root, robot, scenario);
  root.tables("move", [&](TableReader& table) {
    const auto index = static_cast<std::uint32_t>(scenario.moves.size());
    read_move(table, robot, scenario, scenario.moves.emplace_back());
    scenario.moves.back().index = index;
  });
  root.tables("fault",
              [&](TableReader& table) { read_fault(table, scenario.duration_s, scenario.faults.emplace_back()); });
  read_serial_tables(root, scenario);
  root.tables("input", [&](TableReader& table) { read_input(table, scenario, scenario.inputs.emplace_back()); });
  if (root.problem_count() == 0) require_changes(root, scenario.inputs);
  scenario.expect.file = scenario.file;
  root.table("expect", [&](TableReader& table) {
    scenario.expect.origins = table.origins();
    if (table.has("output")) scenario.expect.outputs.emplace();  // also when there is none: no output may change
    table.tables("output", [&](TableReader& output) {
      read_expected_output(output, scenario.duration_s, *scenario.expect.outputs);
    });
    read_expect(table, robot, paper_keys, scenario.expect);
    for (const std::string_view key : {"serial_text", "serial_hex"}) {
      if (table.has(key) && !scenario.serial) table.problem(key, "needs a table [serial]");
    }
  });
  root.table("golden", [&](TableReader& table) { read_golden(table, scenario.golden); });
  root.finish();
  sort_by_time(scenario.moves);
  sort_by_time(scenario.faults);
  sort_by_time(scenario.serial_sends);
  sort_by_time(scenario.inputs);
}

}  // namespace armature::cosim
