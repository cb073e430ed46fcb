// The types `dout` and `wait_din` of [[move]]: commands for the pins of the tool.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/message/command.hpp"
#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"

namespace armature::cosim {

// The keys of a command for a pin of the tool.
template <class Kind>
[[nodiscard]] Keys<Kind> pin_keys() {
  return {pin_key<Kind>("Number of the output or input."),
          level_key<Kind>("Level of the output, or level that the wait ends at: 0 is low, 1 is high.")};
}

struct DoutSpec {
  std::int64_t pin = 1;
  bool level = false;
};

template <>
[[nodiscard]] inline const MoveEntry<DoutSpec>& move_entry<DoutSpec>() {
  static const MoveEntry<DoutSpec> kEntry{
      .name = "dout",
      .command = [](const DoutSpec& output, Tag tag) -> Command {
        return SetOutput{.pin = static_cast<std::uint8_t>(output.pin), .level = output.level, .tag = tag};
      },
      .text = "switches an output of the tool",
      .queued = true,
      .keys = pin_keys<DoutSpec>()};
  return kEntry;
}

struct WaitDinSpec {
  std::int64_t pin = 1;
  bool level = false;
  double timeout_s = 0;  // 0: no limit
};

template <>
[[nodiscard]] inline const MoveEntry<WaitDinSpec>& move_entry<WaitDinSpec>() {
  constexpr double kMaxTimeoutS = 86'400;
  static const MoveEntry<WaitDinSpec> kEntry = [] {
    MoveEntry<WaitDinSpec> entry{.name = "wait_din",
                                 .command = [](const WaitDinSpec& wait, Tag tag) -> Command {
                                   return WaitInput{.pin = static_cast<std::uint8_t>(wait.pin),
                                                    .level = wait.level,
                                                    .timeout = at_least_ticks(wait.timeout_s),
                                                    .tag = tag};
                                 },
                                 .text = "delays the commands after it until an input has the given level",
                                 .queued = true,
                                 .keys = pin_keys<WaitDinSpec>()};
    entry.keys.push_back(
        key("timeout_s", &WaitDinSpec::timeout_s, above(0, kMaxTimeoutS, "s"),
            "Longest time of the wait. When it has passed, the controller drops the wait and all moves after it.")
            .without("no limit"));
    return entry;
  }();
  return kEntry;
}

}  // namespace armature::cosim
