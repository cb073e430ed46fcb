// The types `dwell`, `hold`, `resume`, `override`, `stop`, `clear_fault` and `home` of [[move]].
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "controller/base/words.hpp"
#include "controller/message/command.hpp"
#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

struct DwellSpec {
  double duration_s = 0;  // above 0
};

template <>
[[nodiscard]] inline const MoveEntry<DwellSpec>& move_entry<DwellSpec>() {
  static const MoveEntry<DwellSpec> kEntry{
      .name = "dwell",
      .command = [](const DwellSpec& dwell, Tag tag) -> Command {
        return Dwell{.duration = at_least_ticks(dwell.duration_s), .tag = tag};
      },
      .text = "stands still between two moves",
      .queued = true,
      .keys = {key("duration_s", &DwellSpec::duration_s, above(0, kMaxDurationS, "s"),
                   "Time from the end of the move before to the start of the next one, in whole ticks of 50 us. An "
                   "override has no effect on it.")
                   .required()},
      .details = [](const DwellSpec& dwell) { return fmt::format(" {} s", number_text(dwell.duration_s)); }};
  return kEntry;
}

struct HoldSpec {};

template <>
[[nodiscard]] inline const MoveEntry<HoldSpec>& move_entry<HoldSpec>() {
  static const MoveEntry<HoldSpec> kEntry{.name = "hold",
                                          .command = [](const HoldSpec&, Tag) -> Command { return Hold{}; },
                                          .text = "brakes on the path and waits there"};
  return kEntry;
}

struct ResumeSpec {};

template <>
[[nodiscard]] inline const MoveEntry<ResumeSpec>& move_entry<ResumeSpec>() {
  static const MoveEntry<ResumeSpec> kEntry{.name = "resume",
                                            .command = [](const ResumeSpec&, Tag) -> Command { return Resume{}; },
                                            .text = "continues after a hold"};
  return kEntry;
}

struct OverrideSpec {
  double speed_percent = 100.0;
};

template <>
[[nodiscard]] inline const MoveEntry<OverrideSpec>& move_entry<OverrideSpec>() {
  constexpr double kMinOverride = 1;
  static const MoveEntry<OverrideSpec> kEntry{
      .name = "override",
      .command = [](const OverrideSpec& wanted, Tag tag) -> Command {
        return SetOverride{.share = wanted.speed_percent / 100.0, .tag = tag};
      },
      .text = "sets the speed of all moves from then on",
      .keys = {key("speed_percent", &OverrideSpec::speed_percent, between(kMinOverride, 100, "percent"),
                   "Speed of all moves from then on, as a share of their own speed.")
                   .required()},
      .details = [](const OverrideSpec& move) { return fmt::format(" {} %", number_text(move.speed_percent)); },
  };
  return kEntry;
}

struct StopSpec {
  Stop::Kind mode = Stop::Kind::kQuick;
};

template <>
[[nodiscard]] inline const MoveEntry<StopSpec>& move_entry<StopSpec>() {
  static const MoveEntry<StopSpec> kEntry{
      .name = "stop",
      .command = [](const StopSpec& stop, Tag) -> Command { return Stop{.kind = stop.mode}; },
      .text = "brakes on the path and drops all moves",
      .keys = {named_key(
          "mode", &StopSpec::mode,
          "`quick`: with the full acceleration of the joints, and with any jerk. `soft`: within the limits of "
          "the move, as a `hold`. In both the drives stay enabled (category 2 of IEC 60204-1).")},
      .details =
          [](const StopSpec& stop) {
            return stop.mode == Stop::Kind::kQuick ? std::string{} : fmt::format(" {}", word_of(stop.mode));
          },
  };
  return kEntry;
}

struct ClearFaultSpec {};

template <>
[[nodiscard]] inline const MoveEntry<ClearFaultSpec>& move_entry<ClearFaultSpec>() {
  static const MoveEntry<ClearFaultSpec> kEntry{
      .name = "clear_fault",
      .command = [](const ClearFaultSpec&, Tag tag) -> Command { return ClearFault{.tag = tag}; },
      .text = "leaves the state Fault when the cause of the fault is gone"};
  return kEntry;
}

struct HomeSpec {
  std::vector<std::int64_t> axes{};  // 1..6; empty: all
};

template <>
[[nodiscard]] inline const MoveEntry<HomeSpec>& move_entry<HomeSpec>() {
  constexpr auto kCheckAxes = [](HomeSpec& home, const KeyContext& context) -> std::string {
    const RobotSpec* robot = context.robot.spec;
    if (robot == nullptr) return {};
    for (const std::int64_t axis : home.axes) {
      const auto index = static_cast<std::size_t>(axis - 1);
      if (index >= robot->axis_count) return fmt::format("the robot has {} axes, found {}", robot->axis_count, axis);
      if (!robot->axes[index].homing)
        return fmt::format("axis {} has no [axis.homing] in {}", axis, context.robot.file);
    }
    return {};
  };
  static const MoveEntry<HomeSpec> kEntry{
      .name = "home",
      .command = [](const HomeSpec& home, Tag tag) -> Command {
        std::uint8_t axes = 0;
        for (const std::int64_t axis : home.axes) axes = static_cast<std::uint8_t>(axes | 1u << (axis - 1));
        return Home{.axes = axes, .tag = tag};
      },
      .text =
          "finds the joint angles by the home switches, when no other move runs or waits, and moves to the home "
          "positions",
      .keys = {key("axes", &HomeSpec::axes, between(1, kAxes), "Numbers of the axes.")
                   .without("all axes")
                   .checked(kCheckAxes)},
  };
  return kEntry;
}

}  // namespace armature::cosim
