#include "cosim/iss/debug/monitor.hpp"

#include <fmt/format.h>

#include "cosim/logic/pin_table.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim::iss {
namespace {

// Of the tick in which the run is; the first trigger begins tick 0.
std::string tick_text(const SimulationState& seen) {
  if (seen.triggers == 0) return "no tick has begun\n";
  return fmt::format("tick {}\n", seen.triggers - 1);
}

std::string pins_text(const SimulationState& seen) {
  std::string text;
  for (const Pin& pin : pins()) {
    text += fmt::format("{:<13} {:<6} {:#x}\n", pin.name, pin.is_input() ? "input" : "output",
                        pin.get(seen.inputs, seen.outputs));
  }
  return text;
}

std::string faults_text(const std::vector<FaultEvent>& faults) {
  if (faults.empty()) return "no fault so far\n";
  std::string text;
  for (const FaultEvent& fault : faults) {
    text += fmt::format("{} in tick {}, cycle {}\n", word_of(fault.cause), fault.where.tick, fault.where.at.value());
  }
  return text;
}

}  // namespace

std::string monitor_help() {
  return "tick      the tick of the controller, 50 us each\n"
         "cycle     the clock cycle of the logic, 20 ns each, and the simulated time\n"
         "pins      the levels of the pins of the logic\n"
         "fault     the faults that the controller has reported so far\n"
         "wave on   writes a waveform from now on, into the file of --vcd\n"
         "wave off  ends the waveform\n"
         "help      this text\n";
}

std::string monitor_text(std::string_view command, const SimulationState& seen, const std::vector<FaultEvent>& faults) {
  if (command == "tick") return tick_text(seen);
  if (command == "cycle") return fmt::format("cycle {}, {:.8f} s\n", seen.now.value(), to_seconds(seen.now));
  if (command == "pins") return pins_text(seen);
  if (command == "fault") return faults_text(faults);
  return fmt::format("no command '{}'; expected tick, cycle, pins, fault, wave on, wave off or help\n",
                     printable(std::string{command}));
}

}  // namespace armature::cosim::iss
