#include "cosim/iss/debug/run_inspector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <span>
#include <utility>
#include <variant>

#include "cosim/fabric/register_table.hpp"
#include "cosim/iss/debug/monitor.hpp"
#include "cosim/snapshot/waiting_copy.hpp"

namespace armature::cosim::iss {
namespace {

// What `make` finds in a copy of this process: what it does there has no effect on the run.
DebugAnswer in_copy(const std::function<DebugAnswer()>& make) {
  auto taken = take_snapshot();
  if (auto* copy = std::get_if<WokenCopy>(&taken)) {
    (void)copy->order<char>();
    try {
      copy->end(make());
    } catch (const std::exception&) {
      copy->end(DebugAnswer{.done = false});
    }
  }
  auto& waiting = std::get<WaitingCopy>(taken);
  std::optional<DebugAnswer> answer;
  if (waiting.wake('\0')) answer = waiting.answer<DebugAnswer>();
  return answer.value_or(DebugAnswer{.done = false});
}

int name_of_register(int number) {
  if (number <= 12) return UC_ARM_REG_R0 + number;
  constexpr std::array kOthers{UC_ARM_REG_SP, UC_ARM_REG_LR, UC_ARM_REG_PC, UC_ARM_REG_CPSR};
  if (number < kFirstDouble) return kOthers.at(static_cast<std::size_t>(number - 13));
  if (number < kFirstDouble + kDoubles) return UC_ARM_REG_D0 + (number - kFirstDouble);
  return UC_ARM_REG_FPSCR;
}

}  // namespace

DebugAnswer RunInspector::answer(const DebugRequest& request, const Standing& at) {
  at_ = at;
  switch (request.kind) {
    case DebugRequest::Kind::kRegisters:
      return registers(request.core);
    case DebugRequest::Kind::kWriteRegister:
      return write_register(request);
    case DebugRequest::Kind::kRead:
      return read(request);
    case DebugRequest::Kind::kWrite:
      return write(request);
    case DebugRequest::Kind::kState:
      return text_answer(state(program_.core(request.core)));
    case DebugRequest::Kind::kMonitor:
      return monitor({request.bytes.begin(), request.bytes.begin() + request.size});
    default:
      return {.done = false};
  }
}

void RunInspector::close_wave() {
  if (std::exchange(wave_is_on_, false)) run_.close_wave();
}

// Whether the registers of the core are those between two instructions.
bool RunInspector::is_between(const ArmCore& core) const {
  return &core == at_.core || core.waits();
}

DebugAnswer RunInspector::registers(int number) {
  const ArmCore& core = program_.core(number);
  DebugAnswer answer;
  for (int i = 0; i < kRegisters; ++i) {
    const int name = name_of_register(i);
    const bool is_long = bytes_of_register(i) == 8;
    answer.registers.at(static_cast<std::size_t>(i)) =
        is_long ? core.read_register<std::uint64_t>(name) : core.read_register<std::uint32_t>(name);
  }
  if (!is_between(core)) answer.registers[kPcNumber] = at_.addresses.at(static_cast<std::size_t>(number));
  return answer;
}

DebugAnswer RunInspector::write_register(const DebugRequest& request) {
  ArmCore& core = program_.core(request.core);
  if (!is_between(core)) return {.done = false};
  written_ = true;
  const int name = name_of_register(request.number);
  if (bytes_of_register(request.number) == 8) {
    core.write_register(name, request.value);
  } else if (request.value != registers(request.core).registers.at(static_cast<std::size_t>(request.number))) {
    core.write_register(name, static_cast<std::uint32_t>(request.value));
    if (request.number == kPcNumber) jumps_ = &core == at_.core;
  }
  return {};
}

DebugAnswer RunInspector::read(const DebugRequest& request) {
  DebugAnswer answer;
  const std::span<const std::uint8_t> memory = program_.bytes_from(request.address);
  answer.size = static_cast<std::uint32_t>(std::min<std::size_t>(memory.size(), request.size));
  std::copy_n(memory.begin(), answer.size, answer.bytes.begin());
  if (memory.empty()) read_logic(request, answer);
  return answer;
}

// Word by word, up to the first one that is no register.
void RunInspector::read_logic(const DebugRequest& request, DebugAnswer& answer) {
  while (answer.size < request.size) {
    const std::uint32_t address = request.address + answer.size, word = address & ~3u;
    if (register_name(scenario_.variant, word).empty()) return;
    const DebugAnswer value = in_copy([&] {
      const BusResponse response = run_.read_and_spoil(word);
      return DebugAnswer{.done = response.error == BusError::kNone, .size = response.data};
    });
    if (!value.done) return;
    for (std::uint32_t byte = address & 3; byte < 4 && answer.size < request.size; ++byte) {
      answer.bytes.at(answer.size++) = static_cast<std::uint8_t>(value.size >> (8 * byte));
    }
  }
}

DebugAnswer RunInspector::write(const DebugRequest& request) {
  const std::span<std::uint8_t> memory = program_.bytes_from(request.address);
  const bool is_code = request.address >= program_.code_begin() && request.address < program_.code_end();
  if (memory.size() < request.size || is_code) return {.done = false};
  std::copy_n(request.bytes.begin(), request.size, memory.begin());
  written_ = true;
  return {};
}

std::string RunInspector::state(const ArmCore& core) const {
  if (&core == at_.core) return "executes";
  return core.waits() ? "waits for an interrupt" : "waits for the bus, or time passes";
}

DebugAnswer RunInspector::monitor(const std::string& command) {
  if (command == "help") return text_answer(monitor_help());
  if (command == "wave on") return text_answer(wave_on());
  if (command == "wave off") return text_answer(wave_off());
  return in_copy([&] { return text_answer(monitor_text(command, run_.look(), run_.faults())); });
}

std::string RunInspector::wave_on() {
  if (!wave_) return "no file for a waveform: start armature-iss debug with --vcd FILE\n";
  if (std::exchange(wave_is_on_, true)) return "the waveform is on already\n";
  run_.write_wave({.file = *wave_, .from = run_.now()});
  return fmt::format("from now on {} is written\n", wave_->string());
}

std::string RunInspector::wave_off() {
  if (!std::exchange(wave_is_on_, false)) return "no waveform is on\n";
  run_.close_wave();
  return fmt::format("{} is complete; the next `wave on` writes it again\n", wave_->string());
}

}  // namespace armature::cosim::iss
