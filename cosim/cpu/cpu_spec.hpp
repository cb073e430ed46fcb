// [cpu]: what the work of the controller costs on a simulated ARM core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/hal/register_bus.hpp"

namespace armature::cosim {

// What runs the controller. Both give the same results, byte for byte.
enum class CpuKind : std::uint8_t {
  kHost,  // the controller as compiled for the host
  kA9,    // its cross-compiled program, in a simulator of ARM instructions
};
inline constexpr std::string_view kCpuHelp =
    "What runs the controller. `host`: the controller as compiled for the host. `a9`: its firmware for the Cortex-A9, "
    "instruction by instruction, which only the program `armature-iss` can. Results do not depend on it.";

// Computing times of the simulated ARM cores, in clock cycles of the logic (20 ns; about 13 CPU cycles at 667 MHz).
// The defaults are what the firmware needs at CPI 1.5: about the mean of a work in the middle one of the scenarios that
// do it, or more. Interrupt entry and tick count together. These means stand behind; cosim/iss/README.md has more.
struct CpuSpec {
  CpuKind processor = CpuKind::kHost;
  std::optional<double> cpi;                       // of kA9: clocks for each instruction; none: the costs below
  std::int64_t interrupt_entry_cycles = 100;       // 2 us; 9 are instructions
  std::int64_t tick_compute_cycles = 350;          // 7 us; 399
  std::int64_t plan_compute_cycles = 850;          // 17 us; 419
  std::int64_t retarget_compute_cycles = 720;      // 14.4 us; 728: a joint plan from a state of motion
  std::int64_t corner_compute_cycles = 7700;       // 154 us: a trial of a corner between joint moves
  std::int64_t window_compute_cycles = 10'700;     // 214 us: the begin of a further part of a path
  std::int64_t inverse_compute_cycles = 350;       // 7 us; 351: a set-point of a path, or a pose of its plan
  std::int64_t program_step_compute_cycles = 200;  // 4 us; 201: a line of a program, or a part of it
  std::int64_t network_compute_cycles = 850;       // 17 us; 819: the network of a belt, some 450 products of bytes
};

// The costs in the order of Work.
inline constexpr std::array kCosts{
    &CpuSpec::interrupt_entry_cycles,  &CpuSpec::tick_compute_cycles,         &CpuSpec::plan_compute_cycles,
    &CpuSpec::retarget_compute_cycles, &CpuSpec::corner_compute_cycles,       &CpuSpec::window_compute_cycles,
    &CpuSpec::inverse_compute_cycles,  &CpuSpec::program_step_compute_cycles, &CpuSpec::network_compute_cycles};
static_assert(kCosts.size() == kWorks);

// The costs of a core whose instructions are charged: none.
[[nodiscard]] constexpr CpuSpec without_costs(CpuSpec spec) noexcept {
  for (const auto cost : kCosts) spec.*cost = 0;
  return spec;
}

// Of one piece of work.
[[nodiscard]] constexpr std::int64_t cycles_of(const CpuSpec& spec, Work work) noexcept {
  return spec.*kCosts[static_cast<std::size_t>(work)];
}

}  // namespace armature::cosim
