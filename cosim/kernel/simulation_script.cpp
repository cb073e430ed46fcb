// The actions of the scenario during the run.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "controller/base/overloaded.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/move_text.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/suggest.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::string unknown_name(std::string_view expected, const std::string& found,
                         const std::vector<std::string_view>& names) {
  const std::string_view near = nearest_name(found, names);
  const std::string hint = near.empty() ? std::string{} : fmt::format(", did you mean \"{}\"?", near);
  return fmt::format("expected {}, found \"{}\"{}", expected, found, hint);
}

}  // namespace

void Simulation::act(const ScriptAction& action) {
  listener_.on_action(action, now());
  std::visit(
      Overloaded{
          [this](const CommandSpec& move) { give(move); },
          [this](const StreamStep& step) {
            Command point = to_command(scenario_.streams[step.stream], step.point);
            if (step.more) std::get<StreamPoint>(point).last = false;
            // The controller then misses the set-point and stops.
            if (host_.submit(Source::kScenario, point)) processor_->notify(now());
            read_host_memory();
          },
          [this](const PartStep&) {
            // Without room the part is never seen.
            if (host_.submit(Source::kScenario, ConveyorPart{.counts = belt_->motion().counts(to_seconds(now()))})) {
              processor_->notify(now());
            }
            read_host_memory();
          },
          [this](const FaultSpec& fault) {
            compute_edges();
            injector_.begin(fault.kind, now());
            after_fault();
          },
          [this](const FaultEnd& end) {
            compute_edges();
            injector_.end(end.fault.kind, now());
            after_fault();
          },
          [this](const InputSpec& input) {
            const auto bit = static_cast<std::uint16_t>(1u << (input.pin - 1));
            tool_inputs_ = static_cast<std::uint16_t>(input.level ? tool_inputs_ | bit : tool_inputs_ & ~bit);
            drive_inputs();
          },
      },
      action);
}

// The flop or the word of memory of a fault.
void Simulation::require_place(const FaultSpec& fault) const {
  const auto fail = [&](std::string_view key, std::string message) {
    throw InputError{Problem{.file = scenario_.file,
                             .origin = {.line = fault.line, .column = 1, .override_text = {}},
                             .key = std::string{key},
                             .message = std::move(message)}};
  };
  if (const auto* flip = std::get_if<MemoryFlip>(&fault.kind)) {
    const CoreMemory& memory = processor_->memory();
    if (!memory.symbols.contains(flip->symbol)) {
      std::vector<std::string_view> names(memory.symbols.size());
      std::ranges::transform(memory.symbols, names.begin(),
                             [](const auto& symbol) { return std::string_view{symbol.first}; });
      fail("symbol", unknown_name("a global symbol of the firmware", flip->symbol, names));
    }
    if (memory.word_at(flip->symbol, flip->offset)) return;
    fail("offset", fmt::format("expected a place in the memory of the cores, found {}", flip->offset));
  }
  const auto* flip = std::get_if<FlopFlip>(&fault.kind);
  if (flip == nullptr) return;
  const std::vector<Flop> flops = soc_->flops();
  const auto found = std::ranges::find(flops, flip->flop, &Flop::name);
  if (found == flops.end()) {
    std::vector<std::string_view> names(flops.size());
    std::ranges::transform(flops, names.begin(), &Flop::name);
    fail("flop", unknown_name("a flop that 'armature flips' lists", flip->flop, names));
  }
  if (flip->bit >= found->bits) fail("bit", fmt::format("expected 0 to {}, found {}", found->bits - 1, flip->bit));
}

// After a fault has begun or ended.
void Simulation::after_fault() {
  conservation_.on_clock(now(), injector_.clock_runs());
  conservation_.do_not_check_positions(injector_.false_encoders());
  conservation_.allow_late_responses(injector_.response_delay());
  if (injector_.has_flipped_flops()) conservation_.stop_checking();
  drive_inputs();
  show_interrupts();
}

void Simulation::give(const CommandSpec& move) {
  if (std::holds_alternative<PolylineSpec>(move.kind) || (program_.busy() && is_queued(move.kind))) {
    program_.add(move);
    feed_program();
    return;
  }
  if (std::holds_alternative<StopSpec>(move.kind)) drop_program(Refusal::kNotReady);
  if (const auto* joint = std::get_if<JointSpec>(&move.kind);
      joint != nullptr && joint->when == JointSpec::When::kNow) {
    replacing_ = move.index;
  }
  if (!host_.submit(Source::kScenario, to_command(move))) {
    listener_.on_event(MoveRefused{.reason = Refusal::kQueueFull, .tag = move.index}, now());
    return;
  }
  processor_->notify(now());
  read_host_memory();
}

void Simulation::feed_program() {
  if (!program_.busy() || !program_.feed(host_)) return;
  processor_->notify(now());
  read_host_memory();
}

void Simulation::drop_program(Refusal reason) {
  for (const std::uint32_t tag : program_.drop_all()) {
    listener_.on_event(MoveRefused{.reason = reason, .tag = tag}, now());
  }
}

}  // namespace armature::cosim
