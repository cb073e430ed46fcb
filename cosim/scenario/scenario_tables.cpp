#include "cosim/scenario/scenario_tables.hpp"

#include <algorithm>
#include <string>

#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxDurationS = 86'400;   // a day
constexpr double kMaxCycles = 50'000'000;  // a second of the 50 MHz clock
constexpr double kMaxTargetDeg = 36'000;   // soft limits are the controller's business; this only catches nonsense
constexpr double kMinSpeedPercent = 0.1;   // slower moves take longer than any run
constexpr double kMaxCount = 1'000'000'000;

void read_controller(TableReader& table, ControllerSpec& controller) {
  table.read("sync", controller.sync, one_of({"fig9", "const_acc", "time_scale"}));
  table.read("feedback", controller.feedback, anything());
}

void read_cpu(TableReader& table, CpuSpec& cpu) {
  table.read("interrupt_entry_cycles", cpu.interrupt_entry_cycles, between(0, kMaxCycles, "cycles"));
  table.read("tick_compute_cycles", cpu.tick_compute_cycles, between(0, kMaxCycles, "cycles"));
  table.read("plan_compute_cycles", cpu.plan_compute_cycles, between(0, kMaxCycles, "cycles"));
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

// Every timed entry must happen during the run.
void read_at(TableReader& table, double duration_s, double& at_s) {
  if (!table.read("at_s", at_s, between(0, kMaxDurationS, "s"), Need::kRequired)) return;
  if (duration_s > 0 && at_s >= duration_s) {
    table.problem("at_s",
                  "expected less than duration_s = " + number_text(duration_s) + ", found " + number_text(at_s));
  }
}

void read_move(TableReader& table, double duration_s, MoveSpec& move) {
  move.line = table.line();
  read_at(table, duration_s, move.at_s);
  std::string type;
  if (!table.read("type", type, one_of({"joint", "stop", "clear_fault"}), Need::kRequired)) {
    table.ignore_rest();
    return;
  }
  if (type == "joint") {
    move.type = MoveType::kJoint;
    table.read("target_deg", move.target_deg, between(-kMaxTargetDeg, kMaxTargetDeg, "deg"), Need::kRequired);
    table.read("speed_percent", move.speed_percent, between(kMinSpeedPercent, 100, "percent"));
  } else {
    move.type = type == "stop" ? MoveType::kStop : MoveType::kClearFault;
    table.refuse({"target_deg", "speed_percent"}, "type = \"joint\"");
  }
}

void read_fault(TableReader& table, double duration_s, FaultSpec& fault) {
  fault.line = table.line();
  read_at(table, duration_s, fault.at_s);
  std::string kind;
  if (!table.read("kind", kind, one_of({"pulse_loss", "slow_core", "estop"}), Need::kRequired)) {
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

void read_golden(TableReader& table, GoldenSpec& golden) {
  constexpr std::size_t kDigits = 64;
  std::string digest;
  if (!table.read("sha256", digest, anything(), Need::kRequired)) return;
  if (digest.size() != kDigits || digest.find_first_not_of("0123456789abcdef") != std::string::npos) {
    table.problem("sha256", "expected 64 lower-case hexadecimal digits, found \"" + digest + "\"");
    return;
  }
  golden.sha256 = digest;
}

template <class Spec>
void sort_by_time(std::vector<Spec>& specs) {
  std::stable_sort(specs.begin(), specs.end(), [](const Spec& a, const Spec& b) { return a.at_s < b.at_s; });
}

}  // namespace

void read_scenario(TableReader& root, Scenario& scenario) {
  root.read("description", scenario.description, anything(), Need::kRequired);
  root.read("robot", scenario.robot_name, anything(), Need::kRequired);
  root.read("duration_s", scenario.duration_s, above(0, kMaxDurationS, "s"), Need::kRequired);
  root.read("seed", scenario.seed, at_least(0));
  root.table("controller", [&](TableReader& table) { read_controller(table, scenario.controller); });
  root.table("cpu", [&](TableReader& table) { read_cpu(table, scenario.cpu); });
  root.table("bus", [&](TableReader& table) { read_bus(table, scenario.bus); });
  root.table("trace", [&](TableReader& table) {
    table.read("every_ticks", scenario.trace.every_ticks, between(1, kMaxCount, "ticks"));
  });
  root.tables("move",
              [&](TableReader& table) { read_move(table, scenario.duration_s, scenario.moves.emplace_back()); });
  root.tables("fault",
              [&](TableReader& table) { read_fault(table, scenario.duration_s, scenario.faults.emplace_back()); });
  root.table("expect", [&](TableReader& table) { read_expect(table, scenario.expect); });
  root.table("golden", [&](TableReader& table) { read_golden(table, scenario.golden); });
  root.finish();
  sort_by_time(scenario.moves);
  sort_by_time(scenario.faults);
}

}  // namespace armature::cosim
