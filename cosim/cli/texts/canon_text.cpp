#include "cosim/cli/texts/canon_text.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>
#include <variant>

#include "controller/base/overloaded.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

std::string numbers(const gcode::Axes6& axes, double unit_mm, std::string_view between = ", ") {
  std::string text;
  for (std::size_t i = 0; i < gcode::kAxes; ++i) {
    fmt::format_to(std::back_inserter(text), "{}{:.4f}", i == 0 ? "" : between, axes[i] / (i < 3 ? unit_mm : 1.0));
  }
  return text;
}

// Linear axes and rotary axes in groups, as for tools.
std::string grouped(const gcode::Axes6& axes, double unit_mm, std::string_view between) {
  return fmt::format("{:.4f} {:.4f} {:.4f}{}{:.4f} {:.4f} {:.4f}{}0.0000 0.0000 0.0000", axes[0] / unit_mm,
                     axes[1] / unit_mm, axes[2] / unit_mm, between, axes[3], axes[4], axes[5], between);
}

std::string control_text(const gcode::SetMotionControlMode& control, double unit_mm) {
  using Mode = gcode::SetMotionControlMode::Mode;
  switch (control.mode) {
    case Mode::kExactPath:
      return "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)";
    case Mode::kExactStop:
      return "SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP)";
    case Mode::kContinuous:
      break;
  }
  return fmt::format("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, {:.6f})", control.tolerance_mm / unit_mm);
}

std::string override_text(const gcode::EnableOverride& call) {
  using Kind = gcode::EnableOverride::Kind;
  const std::string_view what = call.on ? "ENABLE" : "DISABLE";
  switch (call.kind) {
    case Kind::kFeed:
      return fmt::format("{}_FEED_OVERRIDE()", what);
    case Kind::kSpeed:
      return fmt::format("{}_SPEED_OVERRIDE(0)", what);
    case Kind::kAdaptiveFeed:
      return fmt::format("{}_ADAPTIVE_FEED()", what);
    case Kind::kFeedHold:
      break;
  }
  return fmt::format("{}_FEED_HOLD()", what);
}

std::string plane_text(gcode::Plane plane) {
  constexpr std::array<std::string_view, 3> kNames{"XY", "XZ", "YZ"};
  return fmt::format("SELECT_PLANE(CANON_PLANE_{})", kNames[static_cast<std::size_t>(plane)]);
}

std::string digital_text(const gcode::SetDigitalOutput& call) {
  return fmt::format("{}_{}_OUTPUT_BIT({})", call.on ? "SET" : "CLEAR", call.with_motion ? "MOTION" : "AUX",
                     call.index);
}

std::string wait_text(const gcode::WaitInput& call) {
  constexpr std::array<std::string_view, 5> kModes{"IMMEDIATE", "RISE", "FALL", "HIGH", "LOW"};
  return fmt::format("WAIT({}, {}, {}, {:.4f})", call.index, call.analog ? "ANALOG_INPUT" : "DIGITAL_INPUT",
                     kModes[static_cast<std::size_t>(call.mode)], call.timeout_s);
}

std::string said_text(const gcode::Text& call) {
  constexpr std::array<std::string_view, 4> kNames{"COMMENT", "MESSAGE", "PRINT", "LOG"};
  return fmt::format("{}(\"{}\")", kNames[static_cast<std::size_t>(call.kind)], printable(call.text, kShowAll));
}

}  // namespace

void CanonText::on_call(const gcode::CanonCall& call, std::uint32_t /*line*/) noexcept {
  if (const auto* units = std::get_if<gcode::UseLengthUnits>(&call)) unit_mm_ = units->inches ? gcode::kMmPerInch : 1.0;
  const double unit = unit_mm_;
  const std::string text = std::visit(
      Overloaded{
          [](const gcode::UseLengthUnits& c) {
            return fmt::format("USE_LENGTH_UNITS(CANON_UNITS_{})", c.inches ? "INCHES" : "MM");
          },
          [unit](const gcode::SetG5xOffset& c) {
            return fmt::format("SET_G5X_OFFSET({}, {})", c.index, numbers(c.offset, unit));
          },
          [unit](const gcode::SetG92Offset& c) { return fmt::format("SET_G92_OFFSET({})", numbers(c.offset, unit)); },
          [](const gcode::SetXyRotation& c) { return fmt::format("SET_XY_ROTATION({:.4f})", c.deg); },
          [unit](const gcode::UseToolLengthOffset& c) {
            return fmt::format("USE_TOOL_LENGTH_OFFSET({})", grouped(c.offset, unit, ", "));
          },
          [](const gcode::SelectPlane& c) { return plane_text(c.plane); },
          [](const gcode::SetFeedMode&) { return std::string{"SET_FEED_MODE(0, 0)"}; },
          [](const gcode::SetFeedRate& c) { return fmt::format("SET_FEED_RATE({:.4f})", c.number); },
          [unit](const gcode::StraightTraverse& c) {
            return fmt::format("STRAIGHT_TRAVERSE({})", numbers(c.end, unit));
          },
          [unit](const gcode::StraightFeed& c) { return fmt::format("STRAIGHT_FEED({})", numbers(c.end, unit)); },
          [unit](const gcode::ArcFeed& c) {
            return fmt::format("ARC_FEED({:.4f}, {:.4f}, {:.4f}, {:.4f}, {}, {:.4f}, {:.4f}, {:.4f}, {:.4f})",
                               c.first_end / unit, c.second_end / unit, c.first_axis / unit, c.second_axis / unit,
                               c.rotation, c.axis_end / unit, c.a, c.b, c.c);
          },
          [](const gcode::Dwell& c) { return fmt::format("DWELL({:.4f})", c.seconds); },
          [unit](const gcode::SetMotionControlMode& c) { return control_text(c, unit); },
          [unit](const gcode::SetNaiveCamTolerance& c) {
            return fmt::format("SET_NAIVECAM_TOLERANCE({:.4f})", c.mm / unit);
          },
          [](const gcode::SelectTool& c) { return fmt::format("SELECT_TOOL({})", c.number); },
          [](const gcode::StartChange&) { return std::string{"START_CHANGE()"}; },
          [](const gcode::ChangeTool& c) { return fmt::format("CHANGE_TOOL({})", c.number); },
          [unit](const gcode::SetToolTableEntry& c) {
            return fmt::format("SET_TOOL_TABLE_ENTRY({0}, {0}, {1}, 0.0000, 0.0000, 0)", c.number,
                               grouped(c.offset, unit, " "));
          },
          [](const gcode::SetSpindleMode& c) { return fmt::format("SET_SPINDLE_MODE(0 {:.4f})", c.max_rpm); },
          [](const gcode::SetSpindleSpeed& c) { return fmt::format("SET_SPINDLE_SPEED(0, {:.4f})", c.rpm); },
          [](const gcode::StartSpindle& c) {
            return fmt::format("START_SPINDLE_{}(0)", c.clockwise ? "CLOCKWISE" : "COUNTERCLOCKWISE");
          },
          [](const gcode::StopSpindle&) { return std::string{"STOP_SPINDLE_TURNING(0)"}; },
          [](const gcode::Mist& c) { return fmt::format("MIST_{}()", c.on ? "ON" : "OFF"); },
          [](const gcode::Flood& c) { return fmt::format("FLOOD_{}()", c.on ? "ON" : "OFF"); },
          [](const gcode::EnableOverride& c) { return override_text(c); },
          [](const gcode::SetDigitalOutput& c) { return digital_text(c); },
          [](const gcode::SetAnalogOutput& c) {
            return fmt::format("SET_{}_OUTPUT_VALUE({},{:.6f})", c.with_motion ? "MOTION" : "AUX", c.index, c.value);
          },
          [](const gcode::WaitInput& c) { return wait_text(c); },
          [](const gcode::Text& c) { return said_text(c); },
          [](const gcode::ProgramStop& c) {
            return std::string{c.optional ? "OPTIONAL_PROGRAM_STOP()" : "PROGRAM_STOP()"};
          },
          [](const gcode::PalletShuttle&) { return std::string{"PALLET_SHUTTLE()"}; },
          [](const gcode::ProgramEnd&) { return std::string{"PROGRAM_END()"}; },
      },
      call);
  fmt::format_to(std::back_inserter(text_), "{:5} N..... {}\n", ++number_, text);
}

}  // namespace armature::cosim
