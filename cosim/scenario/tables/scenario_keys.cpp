// A scenario file: its own keys and its tables.
#include <fmt/format.h>

#include <string>

#include "controller/base/timebase.hpp"
#include "controller/message/command.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

std::string check_duration(const Scenario& scenario, const KeyContext&) {
  if (scenario.duration_s >= kTickSeconds) return {};
  return "expected at least " + number_text(kTickSeconds) + " (s), one tick of the controller, found " +
         number_text(scenario.duration_s);
}

std::string check_program(const Scenario& scenario, const KeyContext&) {
  if (program_language(*scenario.program) != ProgramLanguage::kNone) return {};
  return fmt::format("expected a file that {}, found \"{}\"", kEndsLikeProgram, printable(*scenario.program));
}

std::string check_start(const Scenario& scenario, const KeyContext&) {
  if (scenario.variant != Variant::kPaper) return {};
  return "the variant paper cannot find its joint angles: its decoder sees one encoder";
}

std::string check_moved_start(const Scenario& scenario, const KeyContext&) {
  return scenario.unreferenced_start_deg ? "not allowed with unreferenced_start_deg" : std::string{};
}

}  // namespace

std::string outside_run(double at_s, const Scenario& scenario) {
  if (scenario.duration_s <= 0 || at_s < scenario.duration_s) return {};
  if (scenario.ends_with_program) {
    return fmt::format("expected less than {}, the longest run without duration_s, found {}",
                       number_text(scenario.duration_s), number_text(at_s));
  }
  return "expected less than duration_s = " + number_text(scenario.duration_s) + ", found " + number_text(at_s);
}

const KeyTable<Scenario>& scenario_keys() {
  static const KeyTable<Scenario> kTable{
      .text = {},
      .keys =
          {
              key("description", &Scenario::description, anything(),
                  "One line about the scenario. `armature list` and the summary show it.")
                  .required(),
              key("robot", &Scenario::robot_name, anything(),
                  "The robot: the name of a file in `robots/` without `.toml`, or a path relative to the scenario file "
                  "that ends in `.toml`.")
                  .required(),
              key("duration_s", &Scenario::duration_s, above(0, kMaxDurationS, "s"),
                  "Simulated time of the run. The least is one tick, 0.00005 s. Without it the run lasts until its "
                  "program is over and all that the scenario does has begun and ended, and 0.1 s longer. If that takes "
                  "more than 600 s, the run fails.")
                  .required_without("program", "until it ends, at most 600 s")
                  .checked(check_duration),
              key("seed", &Scenario::seed, at_least(0),
                  "Seed of the random numbers: the stalls of the bus and `input_jitter`."),
              key("input_jitter", &Scenario::input_jitter, anything(),
                  "If true, each change of an input pin reaches the logic with the next clock edge or with the one "
                  "after it, at random, as with a real synchroniser."),
              key("unreferenced_start_deg", &Scenario::unreferenced_start_deg,
                  between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "Joint angles at which the arm stands at the start, without the controller knowing them. It refuses "
                  "all motions until a `home` has succeeded for all axes.")
                  .without("the arm stands at 0, and the controller knows it")
                  .checked(check_start),
              key("moved_start_deg", &Scenario::moved_start_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "Joint angles at which the arm stands at the start, while the controller takes it to be at 0, as if "
                  "somebody had moved it without power. The logic notices it at the first index of an encoder, but not "
                  "in "
                  "whole turns of a motor. The variant paper never notices it.")
                  .without("the arm stands where the controller takes it to be")
                  .checked(check_moved_start),
              key("drop_out_us", &Scenario::drop_out_us, above(0, 1'000'000, "us"),
                  "An external relay removes the servo power of all drives when the pin `heartbeat_o` has been "
                  "constant for this time. It closes again after all servo enables have been low.")
                  .without("no relay"),
              key("program", &Scenario::program, anything(),
                  "File of a program that the controller executes, relative to the scenario file: G-code in the "
                  "language of LinuxCNC (`.ngc`, `.nc` or `.gcode`), or a robot program that is compatible with INFORM "
                  "(`.jbi`). The jobs that a robot program calls are in files of their names beside it. The run fails "
                  "if it ends before the program. The program begins when the arm stands at the end of all "
                  "`[[move]]`s.")
                  .without("no program")
                  .checked(check_program),
              key("program_at_s", &Scenario::program_at_s, between(0, kMaxDurationS, "s"),
                  "Earliest time at which the program begins.")
                  .without("0; with `[pendant]` when the pendant sends `run`")
                  .only(beside("program"))
                  .checked([](Scenario& scenario, const KeyContext&) {
                    return outside_run(*scenario.program_at_s, scenario);
                  }),
              key("program_resumes_after_s", &Scenario::program_resumes_after_s, between(0, kMaxDurationS, "s"),
                  "Time after which a program that has paused (M0, M1, M60, PAUSE) continues, as if an operator had "
                  "pressed start. Not with `[pendant]`, whose operator sends `resume`.")
                  .without("it stays paused")
                  .only(beside("program")),
              named_key("variant", &Scenario::variant,
                        "The variant of the programmable logic. `counts`: the controller sends a signed pulse count "
                        "for each axis and tick. `paper`: the logic as Vo 2021 describes it, with half periods instead "
                        "of counts and one decoder for all encoders. `run --variant` overrides the key."),
              named_key("engine", &Scenario::engine, kEngineHelp),
          },
      // The checks of a table may use the tables above it.
      .tables = {
          table("paper", &Scenario::paper, paper_keys()).needing(Needs::kPaper),
          table("controller", &Scenario::controller, controller_keys()),
          table("kinematics", &Scenario::kinematics, solver_keys()).needing(Needs::kKinematics),
          table("cpu", &Scenario::cpu, cpu_keys()),
          table("bus", &Scenario::bus, bus_keys()),
          table("trace", &Scenario::trace, trace_keys()),
          table("tool", &Scenario::tool, tool_keys()).needing(Needs::kKinematics),
          tables("frame", &Scenario::frames, frame_keys(), kUserFrames).needing(Needs::kKinematics),
          table("conveyor", &Scenario::conveyor, conveyor_keys()).needing(Needs::kKinematics),
          tables("move", &Scenario::moves, move_keys()),
          tables("stream", &Scenario::streams, stream_keys()),
          tables("fault", &Scenario::faults, fault_keys()),
          table("serial", &Scenario::serial, serial_keys()),
          tables("serial_send", &Scenario::serial_sends, serial_send_keys()).needing(Needs::kSerial),
          table("pendant", &Scenario::pendant, pendant_keys()),
          table("gcode", &Scenario::gcode, gcode_keys()).needing(Needs::kGcode),
          table("job", &Scenario::job, job_keys()).needing(Needs::kJob),
          tables("input", &Scenario::inputs, input_keys()),
          table("expect", &Scenario::expect, expect_keys()),
          table("golden", &Scenario::golden, golden_keys()),
      }};
  return kTable;
}

TableInfo scenario_file() {
  return scenario_keys().info();
}

}  // namespace armature::cosim
