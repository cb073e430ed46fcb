// Where a run stops: the steps and stop points of gdb, looked for at each instruction and access of both cores.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cosim/iss/core_watcher.hpp"
#include "cosim/iss/debug/protocol/target.hpp"

namespace armature::cosim::iss {

class StopRules {
 public:
  // Nothing stops the run until set().
  void clear() { *this = StopRules{}; }
  // From the next instruction on. The one at which the run stands does not stop it again.
  void set(const Resume& how, std::span<const StopPoint> points);
  // At the next instruction of either core.
  void interrupt() { interrupted_ = active_ = true; }

  // Whether at_instruction() has anything to look for.
  [[nodiscard]] bool active() const { return active_; }
  // A core is about to execute the instruction at `address`. Does it stop here?
  [[nodiscard]] std::optional<Stop> at_instruction(int core, std::uint32_t address);
  // An instruction of the core accesses data. Does it stop behind this instruction?
  [[nodiscard]] std::optional<Stop> at_data(int core, const DataAccess& access) const;

 private:
  static constexpr std::size_t kFilterBits = 4096;
  [[nodiscard]] static std::size_t filter_bit(std::uint32_t address) { return address / 2 % kFilterBits; }

  std::vector<StopPoint> breakpoints_, watched_;
  std::array<bool, kFilterBits> filter_{};  // may a breakpoint be at an address with this bit
  std::optional<Resume> step_;
  bool interrupted_ = false;
  bool active_ = false;
};

}  // namespace armature::cosim::iss
