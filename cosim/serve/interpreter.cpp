#include "cosim/serve/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <vector>

#include "cosim/logic/pin_table.hpp"
#include "cosim/serve/interpreter_command.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kWord = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kStrobes = 0xF;

template <class... Values>
void append(std::string& out, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

void require(const BusResponse& response, std::uint32_t addr, Cycles timeout) {
  switch (response.error) {
    case BusError::kNone:
      return;
    case BusError::kSlaveError:
      throw CommandRefused{fmt::format("SLVERR at 0x{:08X}: the block refused the access", addr)};
    case BusError::kDecodeError:
      throw CommandRefused{fmt::format("DECERR at 0x{:08X}: there is no block", addr)};
    case BusError::kTimeout:
      throw CommandRefused{fmt::format("TIMEOUT at 0x{:08X}: no answer within {} cycles", addr, timeout.value())};
  }
}

[[noreturn]] void refuse_pin(std::string_view name) {
  if (name.starts_with("clk_")) {
    throw CommandRefused{fmt::format("{} is moved by run and by every access", in_quotes(name))};
  }
  if (name == "rst_ni") throw CommandRefused{"rst_ni was released before cycle 0 and stays high"};
  if (name.starts_with("s_axi_")) throw CommandRefused{"the bus belongs to r and w, it is idle between them"};
  std::vector<std::string_view> names;
  for (const Pin& pin : pins()) names.push_back(pin.name);
  const std::string_view near = nearest_name(name.substr(0, 40), names);
  throw CommandRefused{fmt::format("no pin {}{}", in_quotes(name),
                                   near.empty() ? "; 'help pin' lists them" : fmt::format(", did you mean {}?", near))};
}

}  // namespace

const Interpreter::Command Interpreter::kCommands[] = {
    {"r", "r ADDR", "read a register: ok 0xVALUE", &Interpreter::read, true},
    {"w", "w ADDR DATA [STRB]", "write a register, bit i of STRB for byte i: ok", &Interpreter::write, true},
    {"run", "run CYCLES", "that many clocks of 20 ns: ok CYCLE", &Interpreter::run, true},
    {"run-until-irq", "run-until-irq MAX", "clocks until a bit of irq_o is high: ok CYCLE", &Interpreter::run_until_irq,
     true},
    {"pin", "pin NAME [VALUE]", "level of a pin, or drive an input from the next clock on", &Interpreter::pin, true},
    {"time", "time", "clocks since reset: ok CYCLE", &Interpreter::time, true},
    {"batch", "batch OPERATION; ...", "many of r, w, run, run-until-irq, pin, time: ok, and a VALUE or - for each",
     &Interpreter::batch},
    {"vcd", "vcd [FILE]",
     "waveform of every signal from now on into FILE below the folder of --out; without FILE: close it",
     &Interpreter::vcd},
    {"help", "help [COMMAND]", "this list, or what a command does", &Interpreter::help},
};

const Interpreter::Command* Interpreter::find(std::string_view name) {
  const auto found = std::ranges::find(kCommands, name, &Command::name);
  return found == std::end(kCommands) ? nullptr : &*found;
}

void Interpreter::answer(std::string_view line, std::string& out, const StopRequest& stop) {
  ++lines_;
  stop_ = &stop;
  cycles_left_ = kMaxCycles;
  const std::size_t begin = out.size();
  try {
    execute(line, out);
  } catch (const CommandRefused& refused) {
    out.resize(begin);
    append(out, "error {}", refused.what());
  } catch (const LogicCheckFailed& failed) {
    broken_ = true;
    out.resize(begin);
    append(out, "error a check inside the logic failed at cycle {}; the server ends", failed.cycle.value());
  } catch (const EnginesDiffer& difference) {
    broken_ = true;
    out.resize(begin);
    append(out, "error the engines differ at cycle {}: {}; the server ends", difference.cycle.value(), difference.what);
  }
  out += '\n';
}

void Interpreter::answer_to_long_line(std::string& out) {
  ++lines_;
  append(out, "error a line has at most {} bytes, a batch {}\n", kMaxLine, kMaxBatchLine);
}

void Interpreter::execute(std::string_view line, std::string& out) {
  const bool long_line = line.size() > kMaxLine;
  if (line.ends_with('\r')) line.remove_suffix(1);
  constexpr std::string_view kHelp = "help";
  CommandWords first{line, kHelp};
  if (first.empty()) throw CommandRefused{"no command; 'help' lists them"};
  const std::string_view name = first.word("command");
  const Command* command = find(name);
  if (long_line && (command == nullptr || command->execute != &Interpreter::batch)) {
    throw CommandRefused{fmt::format("a line has at most {} bytes, a batch {}", kMaxLine, kMaxBatchLine)};
  }
  if (command == nullptr) throw CommandRefused{fmt::format("no command {}; 'help' lists them", in_quotes(name))};
  CommandWords words{first.rest(), command->usage};
  (this->*command->execute)(words, out);
}

void Interpreter::read(CommandWords& words, std::string& out) {
  const auto addr = static_cast<std::uint32_t>(words.number("ADDR", kWord));
  words.finish();
  const BusResponse response = soc_.access({.write = false, .addr = addr});
  require(response, addr, soc_.access_timeout());
  append(out, "ok 0x{:08X}", response.data);
}

void Interpreter::write(CommandWords& words, std::string& out) {
  BusRequest request{.write = true};
  request.addr = static_cast<std::uint32_t>(words.number("ADDR", kWord));
  request.data = static_cast<std::uint32_t>(words.number("DATA", kWord));
  if (!words.empty()) request.strobes = static_cast<std::uint8_t>(words.number("STRB", kStrobes));
  words.finish();
  require(soc_.access(request), request.addr, soc_.access_timeout());
  out += "ok";
}

Cycles Interpreter::cycles_to_run(CommandWords& words, std::string_view what) {
  const auto cycles = static_cast<std::int64_t>(words.number(what, kMaxCycles));
  words.finish();
  if (cycles > cycles_left_) throw CommandRefused{fmt::format("a batch runs at most {} cycles", kMaxCycles)};
  cycles_left_ -= cycles;
  return Cycles{cycles};
}

void Interpreter::run(CommandWords& words, std::string& out) {
  const Cycles cycles = cycles_to_run(words, "CYCLES");
  if (!soc_.run(cycles, *stop_)) throw CommandRefused{fmt::format("interrupted at cycle {}", soc_.now().value())};
  append(out, "ok {}", soc_.now().value());
}

void Interpreter::run_until_irq(CommandWords& words, std::string& out) {
  const Cycles max = cycles_to_run(words, "MAX");
  const std::optional<bool> active = soc_.run_until_irq(max, *stop_);
  if (!active) throw CommandRefused{fmt::format("interrupted at cycle {}", soc_.now().value())};
  if (!*active) throw CommandRefused{fmt::format("no interrupt within {} cycles", max.value())};
  append(out, "ok {}", soc_.now().value());
}

void Interpreter::pin(CommandWords& words, std::string& out) {
  const std::string_view name = words.word("NAME");
  const Pin* pin = find_pin(name);
  if (pin == nullptr) refuse_pin(name);
  if (words.empty()) {
    append(out, "ok 0x{:X}", pin->get(soc_.inputs(), soc_.outputs()));
    return;
  }
  if (!pin->is_input()) throw CommandRefused{fmt::format("{} is an output of the logic", pin->name)};
  SocInputs inputs = soc_.inputs();
  pin->set(inputs, static_cast<std::uint32_t>(words.number("VALUE", pin->max_value())));
  words.finish();
  soc_.set_inputs(inputs);
  out += "ok";
}

void Interpreter::time(CommandWords& words, std::string& out) {
  words.finish();
  append(out, "ok {}", soc_.now().value());
}

void Interpreter::vcd(CommandWords& words, std::string& out) {
  const fs::path file{words.rest()};
  FileDescriptor opened;
  if (!file.empty()) opened = waves_.open(file);
  // The text of WaveError contains the name of the file and may be longer than an answer.
  try {
    soc_.close_wave();
  } catch (const WaveError&) {
    throw CommandRefused{"the waveform file before could not be written completely; it is closed"};
  }
  try {
    // This name refers to the file that was opened, even if the file has been renamed since.
    if (opened) soc_.open_wave(fmt::format("/proc/self/fd/{}", opened.get()), WaveFormat::kVcd);
  } catch (const WaveError&) {
    throw CommandRefused{fmt::format("cannot write {}; no waveform is written now", in_quotes(file.native()))};
  }
  out += "ok";
}

void Interpreter::help(CommandWords& words, std::string& out) {
  if (words.empty()) {
    out += "ok";
    for (const Command& command : kCommands) append(out, "{} {}", &command == kCommands ? "" : " |", command.usage);
    return;
  }
  const std::string_view name = words.word("COMMAND");
  words.finish();
  const Command* command = find(name);
  if (command == nullptr) throw CommandRefused{fmt::format("no command {}; 'help' lists them", in_quotes(name))};
  append(out, "ok {}: {}", command->usage, command->what);
  if (command->name != "pin") return;
  out += ". Pins:";
  for (const Pin& pin : pins()) {
    append(out, " {}", pin.name);
    if (pin.bits > 1) append(out, "[{}:0]", pin.bits - 1);
  }
}

}  // namespace armature::cosim
