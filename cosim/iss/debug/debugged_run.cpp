#include "cosim/iss/debug/debugged_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "controller/base/timebase.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/fabric/register_table.hpp"
#include "cosim/iss/arm_program.hpp"
#include "cosim/iss/debug/monitor.hpp"
#include "cosim/iss/debug/run_messages.hpp"
#include "cosim/iss/debug/stop_rules.hpp"
#include "cosim/iss/firmware.hpp"
#include "cosim/report/format/summary_text.hpp"
#include "cosim/run/golden_listener.hpp"
#include "cosim/run/run.hpp"
#include "cosim/snapshot/waiting_copy.hpp"

namespace armature::cosim::iss {
namespace {

using Clock = std::chrono::steady_clock;

DebugAnswer text_answer(std::string_view text) {
  DebugAnswer answer;
  answer.size = static_cast<std::uint32_t>(std::min(text.size(), kMessageBytes));
  std::copy_n(text.begin(), answer.size, answer.bytes.begin());
  return answer;
}

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

class DebuggedRun final : private CoreWatcher {
 public:
  DebuggedRun(const Scenario& scenario, const DebuggedRunOptions& options, MessageChannel& channel)
      : scenario_{scenario}, options_{options}, channel_{channel} {
    CoreWatcher* const watcher = this;
    provide_a9([&, watcher](host_memory::HostMemory& memory, const CpuSpec& spec) -> std::unique_ptr<CoreProgram> {
      auto program = std::make_unique<ArmProgram>(firmware(), memory, spec.cpi, watcher);
      program_ = program.get();
      return program;
    });
    run_ = std::make_unique<Run>(scenario);
    if (options.compare_golden) run_->add(golden_.emplace(scenario, TraceFile{}));
  }

  [[noreturn]] void serve() {
    rules_.set({.how = Resume::How::kStep, .core = 0}, {});
    while (run_->advance(run_->now() + armature::kTickCycles)) {
      if (channel_.is_due()) take_interrupt();
    }
    RunSummary summary = run_->finish();
    summary.host.wall_s = std::chrono::duration<double>(worked_ + (Clock::now() - since_)).count();
    end(summary_text(summary), {.why = Stop::Why::kEnded, .exit_code = summary.passed() ? kExitOk : kExitCheckFailed});
  }

  // Tells `text` and the last stop.
  [[noreturn]] void end(std::string_view text, const Stop& stop) {
    while (!text.empty()) {
      DebugAnswer part = text_answer(text);
      part.kind = DebugAnswer::Kind::kText;
      channel_.send(part);
      text.remove_prefix(part.size);
    }
    channel_.send(DebugAnswer{.kind = DebugAnswer::Kind::kStopped, .stop = stop});
    ::_exit(EXIT_SUCCESS);
  }

 private:
  void before_instruction(ArmCore& core, std::uint32_t address) noexcept override {
    addresses_[static_cast<std::size_t>(core.number())] = address;
    if (!rules_.active() && !pending_) return;
    std::optional<Stop> stop;
    if (pending_ && pending_->core == core.number()) {
      stop = pending_;
    } else if (rules_.active()) {
      stop = rules_.at_instruction(core.number(), address);
      // The engine begins again at the pc that gdb has set: nothing was executed.
      if (std::exchange(jumps_, false) && stop && stop->why == Stop::Why::kStep) stop.reset();
    }
    if (stop) stand_at(core, *stop);
  }

  void on_data(ArmCore& core, const DataAccess& access) noexcept override {
    if (!pending_) pending_ = rules_.at_data(core.number(), access);
  }

  // An exception must not pass through the engine.
  void stand_at(ArmCore& core, const Stop& stop) noexcept try {
    pending_.reset();
    rules_.clear();
    standing_ = &core;
    worked_ += Clock::now() - since_;
    channel_.send(DebugAnswer{.kind = DebugAnswer::Kind::kStopped, .stop = stop});
    do {
      const std::optional<DebugRequest> request = channel_.receive<DebugRequest>();
      if (!request) ::_exit(EXIT_SUCCESS);
      if (const std::optional<DebugAnswer> answer = fulfil(*request)) channel_.send(*answer);
    } while (standing_ != nullptr);
    since_ = Clock::now();
  } catch (const std::exception& error) {
    end(fmt::format("{}\n", error.what()), {.why = Stop::Why::kFailed});
  }

  // Of a run that continues: nothing else is asked of it.
  void take_interrupt() {
    if (!channel_.receive<DebugRequest>()) ::_exit(EXIT_SUCCESS);
    rules_.interrupt();
  }

  std::optional<DebugAnswer> fulfil(const DebugRequest& request) {
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
        return text_answer(state(program_->core(request.core)));
      case DebugRequest::Kind::kMonitor:
        return monitor({request.bytes.begin(), request.bytes.begin() + request.size});
      case DebugRequest::Kind::kResume:
        rules_.set(request.go_on.how, std::span{request.go_on.points}.first(request.go_on.count));
        standing_ = nullptr;
        break;
      case DebugRequest::Kind::kDetach:
        standing_ = nullptr;
        break;
      case DebugRequest::Kind::kInterrupt:
        break;  // it stands already
    }
    return std::nullopt;
  }

  // Whether the registers of the core are those between two instructions.
  [[nodiscard]] bool is_between(const ArmCore& core) const { return &core == standing_ || core.waits(); }

  [[nodiscard]] DebugAnswer registers(int number) {
    const ArmCore& core = program_->core(number);
    DebugAnswer answer;
    for (int i = 0; i < kRegisters; ++i) {
      const int name = name_of_register(i);
      const bool is_long = bytes_of_register(i) == 8;
      answer.registers.at(static_cast<std::size_t>(i)) =
          is_long ? core.read_register<std::uint64_t>(name) : core.read_register<std::uint32_t>(name);
    }
    if (!is_between(core)) answer.registers[kPcNumber] = addresses_.at(static_cast<std::size_t>(number));
    return answer;
  }

  [[nodiscard]] DebugAnswer write_register(const DebugRequest& request) {
    ArmCore& core = program_->core(request.core);
    if (!is_between(core)) return {.done = false};
    const int name = name_of_register(request.number);
    if (bytes_of_register(request.number) == 8) {
      core.write_register(name, request.value);
    } else if (request.value != registers(request.core).registers.at(static_cast<std::size_t>(request.number))) {
      core.write_register(name, static_cast<std::uint32_t>(request.value));
      if (request.number == kPcNumber) jumps_ = &core == standing_;
    }
    return {};
  }

  [[nodiscard]] DebugAnswer read(const DebugRequest& request) {
    DebugAnswer answer;
    const std::span<const std::uint8_t> memory = program_->memory(request.address);
    answer.size = static_cast<std::uint32_t>(std::min<std::size_t>(memory.size(), request.size));
    std::copy_n(memory.begin(), answer.size, answer.bytes.begin());
    if (memory.empty()) read_logic(request, answer);
    return answer;
  }

  // Word by word, up to the first one that is no register.
  void read_logic(const DebugRequest& request, DebugAnswer& answer) {
    while (answer.size < request.size) {
      const std::uint32_t address = request.address + answer.size, word = address & ~3u;
      if (register_name(scenario_.variant, word).empty()) return;
      const DebugAnswer value = in_copy([&] {
        const BusResponse response = run_->read_and_spoil(word);
        return DebugAnswer{.done = response.error == BusError::kNone, .size = response.data};
      });
      if (!value.done) return;
      for (std::uint32_t byte = address & 3; byte < 4 && answer.size < request.size; ++byte) {
        answer.bytes.at(answer.size++) = static_cast<std::uint8_t>(value.size >> (8 * byte));
      }
    }
  }

  [[nodiscard]] DebugAnswer write(const DebugRequest& request) {
    const std::span<std::uint8_t> memory = program_->memory(request.address);
    const bool is_code = request.address >= program_->code_begin() && request.address < program_->code_end();
    if (memory.size() < request.size || is_code) return {.done = false};
    std::copy_n(request.bytes.begin(), request.size, memory.begin());
    return {};
  }

  [[nodiscard]] std::string state(const ArmCore& core) const {
    if (&core == standing_) return "executes";
    return core.waits() ? "waits for an interrupt" : "waits for the bus, or time passes";
  }

  [[nodiscard]] DebugAnswer monitor(const std::string& command) {
    if (command == "help") return text_answer(monitor_help());
    if (command == "wave on") return text_answer(wave_on());
    if (command == "wave off") return text_answer(wave_off());
    return in_copy([&] { return text_answer(monitor_text(command, run_->look(), run_->faults())); });
  }

  std::string wave_on() {
    if (!options_.wave) return "no file for a waveform: start armature-iss debug with --vcd FILE\n";
    if (std::exchange(wave_is_on_, true)) return "the waveform is on already\n";
    run_->write_wave({.file = *options_.wave, .from = run_->now()});
    return fmt::format("from now on {} is written\n", options_.wave->string());
  }

  std::string wave_off() {
    if (!std::exchange(wave_is_on_, false)) return "no waveform is on\n";
    run_->close_wave();
    return fmt::format("{} is complete; the next `wave on` writes it again\n", options_.wave->string());
  }

  const Scenario& scenario_;
  const DebuggedRunOptions& options_;
  MessageChannel& channel_;
  ArmProgram* program_ = nullptr;
  std::optional<GoldenListener> golden_;
  std::unique_ptr<Run> run_;
  StopRules rules_;
  std::optional<Stop> pending_;               // at the next instruction of its core
  std::array<std::uint32_t, 2> addresses_{};  // of the latest instruction of each core
  ArmCore* standing_ = nullptr;               // the core before whose instruction the run stands
  bool jumps_ = false;                        // it continues at another pc
  bool wave_is_on_ = false;
  Clock::time_point since_ = Clock::now();  // the run continues
  Clock::duration worked_{};                // before that
};

}  // namespace

void serve_debugged_run(const Scenario& scenario, const DebuggedRunOptions& options, MessageChannel& channel) {
  std::optional<DebuggedRun> run;
  std::string error;
  try {
    run.emplace(scenario, options, channel).serve();
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  DebugAnswer text = text_answer(error + '\n');
  text.kind = DebugAnswer::Kind::kText;
  channel.send(text);
  channel.send(DebugAnswer{.kind = DebugAnswer::Kind::kStopped, .stop = {.why = Stop::Why::kFailed}});
  ::_exit(EXIT_FAILURE);
}

}  // namespace armature::cosim::iss
