// The system around the robot: controller, cores, bus, the variant of the paper, trace and golden.
#include <cstddef>
#include <string>

#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxStretch = 1000;

std::string check_feedback(const ControllerSpec& controller, const KeyContext& context) {
  if (context.scenario->variant != Variant::kPaper || !controller.feedback) return {};
  return "expected false with variant = \"paper\", whose decoder sees one encoder, found true";
}

std::string check_solver(const SolverSpec& kinematics, const KeyContext& context) {
  if (context.scenario->variant != Variant::kPaper || kinematics.solver == SetPointSolver::kSoftware) return {};
  return "expected \"software\" with variant = \"paper\", which has no block ik_cordic, found \"cordic\"";
}

std::string check_encoder_axis(const PaperSpec& paper, const KeyContext& context) {
  const std::size_t axes = context.robot.axis_count();
  if (axes == 0 || paper.encoder_axis <= static_cast<std::int64_t>(axes)) return {};
  return "expected an axis of the robot, at most " + std::to_string(axes) + ", found " +
         std::to_string(paper.encoder_axis);
}

std::string check_tcp(const TraceSpec& trace, const KeyContext& context) {
  return trace.tcp == true ? context.lack_of(Needs::kKinematics) : std::string{};
}

void check_bus(TableReader& table, const KeyContext&, const BusSpec& bus) {
  if (bus.timeout_cycles > 2 * bus.latency_cycles) return;
  table.problem("timeout_cycles", "expected more than twice latency_cycles = " + std::to_string(bus.latency_cycles) +
                                      ", found " + std::to_string(bus.timeout_cycles));
}

std::string set_digest(GoldenSpec& golden, const std::string& digest) {
  constexpr std::size_t kDigits = 64;
  if (digest.size() != kDigits || digest.find_first_not_of("0123456789abcdef") != std::string::npos) {
    return "expected 64 lower-case hexadecimal digits, found \"" + printable(digest) + "\"";
  }
  golden.sha256 = digest;
  return {};
}

}  // namespace

const KeyTable<ControllerSpec>& controller_keys() {
  static const KeyTable<ControllerSpec> kTable{
      .text = "Settings of the controller on the ARM cores.",
      .keys = {
          key("sync", &ControllerSpec::sync, one_of({"fig9", "const_acc", "time_scale"}),
              "How a joint move synchronises its joints: all joints get the duration of the slowest one. `fig9`: a "
              "joint with a trapezoid keeps its acceleration and cruises more slowly, and a joint with a triangle "
              "keeps the triangle. Only this rule gives Figure 9 of Vo 2021. `const_acc`: every joint keeps its "
              "acceleration. `time_scale`: the profile of each joint is stretched in time."),
          key("feedback", &ControllerSpec::feedback, anything(),
              "If true, the encoders correct the commanded pulses. Must be false with `variant = \"paper\"`, which has "
              "no feedback.")
              .checked(check_feedback),
          key("max_stretch", &ControllerSpec::max_stretch, between(1, kMaxStretch),
              "Largest factor by which the controller slows a path down to keep the limits of the joints. It refuses a "
              "path that needs more."),
      }};
  return kTable;
}

const KeyTable<SolverSpec>& solver_keys() {
  static const KeyTable<SolverSpec> kTable{
      .text = "The inverse kinematics of core 0, which computes the set-points of planned paths.",
      .keys = {
          named_key("solver", &SolverSpec::solver,
                    "What solves the pose of each set-point. `software`: the controller. `cordic`: the block "
                    "`ik_cordic` of the logic, which takes 25 us of the tick of 50 us. The controller then solves each "
                    "pose, too: if a joint angle differs by more than the block states, the arm stops with the fault "
                    "`inverse_kinematics`. Near a singularity, where the block states no error, the angles are those "
                    "of the software, as they are for jogs and a conveyor. `cordic` is not for `variant = \"paper\"`.")
              .checked(check_solver),
      }};
  return kTable;
}

const KeyTable<CpuSpec>& cpu_keys() {
  static const KeyTable<CpuSpec> kTable{
      .text =
          "Computing times of the simulated ARM cores, in clock cycles of the logic. One cycle is 20 ns, which is "
          "about 13 CPU cycles at 667 MHz. The defaults are what the firmware needs at `cpi = 1.5` in an "
          "ordinary scenario.",
      .keys = {
          named_key("processor", &CpuSpec::processor, kCpuHelp),
          key("cpi", &CpuSpec::cpi, between(0.1, 100, "clocks"),
              "Clocks of a Cortex-A9 for each instruction, at 667 MHz. Instructions then take this time, and the costs "
              "below do not count. The fault `slow_core` adds its time. load.csv and summary.json have the "
              "instructions of a tick. Needs `processor = \"a9\"`."),
          key("interrupt_entry_cycles", &CpuSpec::interrupt_entry_cycles, between(0, kMaxCycles, "cycles"),
              "Interrupt latency: time from the interrupt to the first instruction of its handler. 9 cycles are "
              "instructions; the rest is an assumption."),
          key("tick_compute_cycles", &CpuSpec::tick_compute_cycles, between(0, kMaxCycles, "cycles"),
              "Time that core 0 needs to compute one tick, without the works below."),
          key("plan_compute_cycles", &CpuSpec::plan_compute_cycles, between(0, kMaxCycles, "cycles"),
              "Time that core 1 needs to plan one joint move, or to begin a path."),
          key("retarget_compute_cycles", &CpuSpec::retarget_compute_cycles, between(0, kMaxCycles, "cycles"),
              "Time that a core needs to plan a joint motion that begins in motion. Core 0 plans over three ticks and "
              "needs this time in each. Core 1 needs it for a corner between a path and a joint move."),
          key("corner_compute_cycles", &CpuSpec::corner_compute_cycles, between(0, kMaxCycles, "cycles"),
              "Time that core 1 needs for one trial of a corner between joint moves. A corner takes up to 34."),
          key("window_compute_cycles", &CpuSpec::window_compute_cycles, between(0, kMaxCycles, "cycles"),
              "Time that core 1 needs to begin a further part of a path that core 0 executes."),
          // At least one: planning without simulated time could keep the host busy between two cycles.
          key("inverse_compute_cycles", &CpuSpec::inverse_compute_cycles, between(1, kMaxCycles, "cycles"),
              "Time for one pose of a path, with its inverse kinematics: that core 0 needs for a set-point, and core 1 "
              "for each pose of its plan."),
          // At least one, for the same reason: a program may have an endless loop.
          key("program_step_compute_cycles", &CpuSpec::program_step_compute_cycles, between(1, kMaxCycles, "cycles"),
              "Time that core 1 needs for one step of a program: a line, or a part of it."),
          key("network_compute_cycles", &CpuSpec::network_compute_cycles, between(0, kMaxCycles, "cycles"),
              "Time that core 0 needs in each tick for the network of `[conveyor.policy]`, with `on = \"arm\"`."),
      }};
  return kTable;
}

const KeyTable<BusSpec>& bus_keys() {
  static const KeyTable<BusSpec> kTable{
      .text = "Timing of the bus between the cores and the logic.",
      .keys =
          {
              key("latency_cycles", &BusSpec::latency_cycles, between(0, 10'000, "cycles"),
                  "Latency of the processing system in each direction: an access is delayed by this time, and so is "
                  "its response."),
              key("timeout_cycles", &BusSpec::timeout_cycles, between(10, kMaxCycles, "cycles"),
                  "An access that takes longer than this ends the run. Must be more than twice `latency_cycles`."),
              key("stall_probability", &BusSpec::stall_probability, between(0, 0.9),
                  "Probability that a channel of the bus stalls, for each channel and cycle. `seed` sets the "
                  "sequence."),
          },
      .checks = {{{"latency_cycles", "timeout_cycles"}, check_bus}}};
  return kTable;
}

const KeyTable<PaperSpec>& paper_keys() {
  static const KeyTable<PaperSpec> kTable{
      .text = "Use of the single encoder decoder of the variant `paper`.",
      .keys = {
          key("encoder_axis", &PaperSpec::encoder_axis, between(1, kAxes),
              "Axis whose encoder is connected to the decoder.")
              .checked(check_encoder_axis),
          key("switch_every_ticks", &PaperSpec::switch_every_ticks, between(2, kMaxCount, "ticks"),
              "Time after which the decoder is switched to the next axis, in turn. The decoder loses the counts of the "
              "first tick after a switch.")
              .replaces("encoder_axis")
              .without("no switching"),
      }};
  return kTable;
}

const KeyTable<TraceSpec>& trace_keys() {
  static const KeyTable<TraceSpec> kTable{
      .text = "Content of `trace.csv`.",
      .keys = {
          key("every_ticks", &TraceSpec::every_ticks, between(1, kMaxCount, "ticks"),
              "Time between two rows of the trace. 1 is the full rate of 20 kHz."),
          key("tcp", &TraceSpec::tcp, anything(),
              "If true, the trace has columns of the tool centre point. This needs `[kinematics]` in the robot file.")
              .without("true if a move has a pose")
              .checked(check_tcp),
      }};
  return kTable;
}

const KeyTable<GoldenSpec>& golden_keys() {
  static const KeyTable<GoldenSpec> kTable{
      .text = "The digest of the golden. `armature bless` writes this table.",
      .keys = {
          set_key<GoldenSpec, std::string>(
              "sha256", set_digest, anything(),
              "SHA-256 of the integers and edges of every tick, as 64 lower-case hexadecimal digits.")
              .required()
              .pattern("^[0-9a-f]{64}$"),
      }};
  return kTable;
}

}  // namespace armature::cosim
