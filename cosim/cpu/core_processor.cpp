#include "cosim/cpu/core_processor.hpp"

#include <algorithm>
#include <utility>

#include "controller/regs/soc_map.hpp"
#include "cosim/time/mixed.hpp"

namespace armature::cosim {
namespace {

// An interrupt line of the chip: its bit, its core, and its name in that core.
struct Line {
  std::uint32_t bit;
  std::size_t core;
  Interrupts name;
};
constexpr std::array<Line, 3> kLines{{{regs::soc::kAxiTimerIrq, 0, Interrupts::kTimer},
                                      {regs::soc::kAxiUart16550Irq, 1, Interrupts::kUart},
                                      {regs::soc::kAxiGpioIrq, 1, Interrupts::kGpio}}};

}  // namespace

CoreProcessor::CoreProcessor(std::unique_ptr<CoreProgram> program, const CpuSpec& spec)
    : program_{std::move(program)},
      cores_{{{0, spec, [this](CoreBus& bus) { program_->main(0, bus); }},
              {1, spec, [this](CoreBus& bus) { program_->main(1, bus); }}}} {}

void CoreProcessor::run_ahead(RunAhead& simulation) {
  if (program_->may_run_ahead()) cores_[0].run_ahead(simulation, cores_[1]);
}

void CoreProcessor::notify(Cycles now) {
  cores_[1].set_event(now);
}

std::optional<Cycles> CoreProcessor::next_event() const {
  const std::optional<Cycles> first = cores_[0].wakes_at(), second = cores_[1].wakes_at();
  if (first && second) return std::min(*first, *second);
  return first ? first : second;
}

void CoreProcessor::advance(Cycles now) {
  for (Core& core : cores_) core.run_if_due(now);
  exchange_events(now);
}

std::optional<Processor::Access> CoreProcessor::next_access() const {
  if (!stray_.empty()) return stray_.front();
  for (const Core& core : cores_) {
    if (core.bus_request()) return Access{.core = core.number(), .request = *core.bus_request()};
  }
  return std::nullopt;
}

void CoreProcessor::complete(const Access& access, const BusResponse& response, Cycles now) {
  if (access.stray && !access.request.write) {
    const std::uint32_t data = response.data ^ access.flips;
    stray_.front() = {.core = 1, .request = {.write = true, .addr = access.request.addr, .data = data}, .stray = true};
  } else if (access.stray) {
    stray_.pop_front();
  } else if (Core& core = cores_.at(static_cast<std::size_t>(access.core)); core.state() != CoreState::kHalted) {
    core.complete(response, now);
  }
}

void CoreProcessor::abort(const Access& access, Cycles now) {
  if (access.stray) stray_.pop_front();
  cores_.at(static_cast<std::size_t>(access.core)).halt(now);
}

void CoreProcessor::write_astray(std::uint32_t addr, std::uint32_t data) {
  stray_.push_back({.core = 1, .request = {.write = true, .addr = addr, .data = data}, .stray = true});
}

void CoreProcessor::flip_astray(std::uint32_t addr, std::uint32_t mask) {
  stray_.push_back({.core = 1, .request = {.write = false, .addr = addr}, .stray = true, .flips = mask});
}

std::optional<std::uint64_t> CoreProcessor::digest() const {
  if (!stray_.empty()) return std::nullopt;
  std::uint64_t waiting = 0;
  for (const Core& core : cores_) {
    const std::optional<std::uint64_t> one = core.waiting_digest();
    if (!one) return std::nullopt;
    waiting = mixed(waiting, *one);
  }
  const std::optional<std::uint64_t> program = program_->digest();  // of megabytes
  return program ? std::optional{mixed(waiting, *program)} : std::nullopt;
}

void CoreProcessor::stop_core_one(Cycles now) {
  cores_[1].halt(now);
}

void CoreProcessor::set_interrupts(std::uint8_t levels, Cycles now) {
  std::array<Interrupts, 2> active{};
  for (const Line& line : kLines) {
    if (((levels >> line.bit) & 1) != 0) active[line.core] = active[line.core] | line.name;
  }
  for (std::size_t i = 0; i < cores_.size(); ++i) cores_[i].set_interrupt_levels(active[i]);
  for (Core& core : cores_) core.wake_if_interrupted(now);
  exchange_events(now);
}

void CoreProcessor::exchange_events(Cycles now) {
  for (bool sent = true; sent;) {
    sent = false;
    if (cores_[0].pop_event_sent()) cores_[1].set_event(now), sent = true;
    if (cores_[1].pop_event_sent()) cores_[0].set_event(now), sent = true;
  }
}

}  // namespace armature::cosim
