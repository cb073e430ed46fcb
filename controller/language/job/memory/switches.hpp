// Instructions that switch an output of the user's choice: a welder, a weaving unit, a tool.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/job/memory/instruction.hpp"

namespace armature::job {

// What the instructions switch.
enum class Device : std::uint8_t { kArc, kWeave, kTool, kCount };
inline constexpr std::size_t kDevices = static_cast<std::size_t>(Device::kCount);

struct Switch {
  std::string_view name;
  Device device;
  bool on;
};
inline constexpr std::array<Switch, 8> kSwitches{{{"ARCON", Device::kArc, true},
                                                  {"ARCOF", Device::kArc, false},
                                                  {"COMARCON", Device::kArc, true},
                                                  {"COMARCOF", Device::kArc, false},
                                                  {"WVON", Device::kWeave, true},
                                                  {"WVOF", Device::kWeave, false},
                                                  {"TOOLON", Device::kTool, true},
                                                  {"TOOLOF", Device::kTool, false}}};

// Nothing for an instruction that switches nothing.
[[nodiscard]] constexpr std::optional<Switch> switch_named(std::string_view name) noexcept {
  for (const Switch& one : kSwitches) {
    if (one.name == name) return one;
  }
  return std::nullopt;
}
[[nodiscard]] inline std::optional<Switch> switch_of(Op op) noexcept {
  return switch_named(instruction_of(op).name);
}

}  // namespace armature::job
