// A bus of a core for tests: keeps what is asked of it, and answers from lists.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "cosim/cpu/core_bus.hpp"

namespace armature::cosim::iss {

struct ScriptedBus final : CoreBus {
  std::int64_t cycle = 0;
  int events = 0;
  std::vector<std::uint32_t> reads;                             // addresses
  std::vector<std::pair<std::uint32_t, std::uint32_t>> writes;  // address, value
  std::vector<std::pair<Work, std::int64_t>> charges;
  std::vector<std::int64_t> times;  // cycles at each read, charge and wait
  std::vector<Interrupts> waits;    // masks
  std::deque<Interrupts> wakes_by;  // what the waits return; then kNone
  std::function<void()> on_pass = [] {};

  std::uint32_t read32(RegAddr addr) noexcept override {
    reads.push_back(addr.value);
    times.push_back(cycle);
    return addr.value + 1;
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override { writes.emplace_back(addr.value, value); }
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override {
    waits.push_back(mask);
    times.push_back(cycle);
    if (wakes_by.empty()) return Interrupts::kNone;
    const Interrupts lines = wakes_by.front();
    wakes_by.pop_front();
    return lines;
  }
  void send_event() noexcept override { ++events; }
  Cycles now() noexcept override { return Cycles{cycle}; }
  void pass(Cycles duration) noexcept override {
    cycle += duration.value();
    on_pass();
  }
  void charge(Work work, std::int64_t count) noexcept override {
    charges.emplace_back(work, count);
    times.push_back(cycle);
  }
};

}  // namespace armature::cosim::iss
