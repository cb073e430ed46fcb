// The parameters that programs only read.
#include "controller/language/gcode/executor.hpp"

namespace armature::gcode {
namespace {

constexpr int kNoMotionCode = 800;
constexpr double kNoCompensationCode = 400.0;
constexpr std::string_view kMachinePlace = "_abs_";
constexpr int kFirstSystemCode = 540;

double flag(bool value) noexcept {
  return value ? 1.0 : 0.0;
}

}  // namespace

std::optional<double> Executor::computed(int number) const noexcept {
  const int axis = number - kPlaceParameter;
  if (number == 5400) return modes_.tool;
  if (axis < 0 || axis >= static_cast<int>(kAxes)) return std::nullopt;
  return place_[static_cast<std::size_t>(axis)] / (axis < 3 ? unit_mm() : 1.0);
}

std::optional<double> Executor::computed(std::string_view name) const noexcept {
  if (name.size() < 2 || name.front() != '_') return std::nullopt;
  if (name.size() == 2) {
    for (std::size_t i = 0; i < kAxes; ++i) {
      if (name[1] == kAxisLetters[i]) return computed(kPlaceParameter + static_cast<int>(i));
    }
  }
  if (name.size() == kMachinePlace.size() + 1 && name.starts_with(kMachinePlace)) {
    for (std::size_t i = 0; i < kAxes; ++i) {
      if (name.back() == kAxisLetters[i]) return offsets_.machine(place_)[i] / (i < 3 ? unit_mm() : 1.0);
    }
  }
  const auto override = [this](EnableOverride::Kind kind) {
    return flag(modes_.overrides[static_cast<std::size_t>(kind)]);
  };
  const int system = static_cast<int>(parameters_.at(kSystemParameter));
  const int system_code = kFirstSystemCode + (system <= 6 ? (system - 1) * 10 : 50 + system - 6);
  constexpr int kPlaneCode = 170;
  const struct {
    std::string_view name;
    double value;
  } values[] = {
      {"_value", returned_.value_or(0.0)},
      {"_value_returned", flag(returned_.has_value())},
      {"_line", static_cast<double>(line_)},
      {"_call_level", static_cast<double>(call_level_)},
      {"_motion_mode", static_cast<double>(modes_.motion == nullptr ? kNoMotionCode : modes_.motion->tenths)},
      {"_plane", static_cast<double>(kPlaneCode + 10 * static_cast<int>(modes_.plane))},
      {"_coord_system", static_cast<double>(system_code)},
      {"_metric", flag(!modes_.inches)},
      {"_imperial", flag(modes_.inches)},
      {"_absolute", flag(!modes_.incremental)},
      {"_incremental", flag(modes_.incremental)},
      {"_inverse_time", flag(modes_.inverse_time)},
      {"_units_per_minute", flag(!modes_.inverse_time)},
      {"_feed", modes_.feed},
      {"_rpm", modes_.speed_rpm},
      {"_spindle_on", flag(modes_.spindle != 0)},
      {"_spindle_cw", flag(modes_.spindle > 0)},
      {"_mist", flag(modes_.mist)},
      {"_flood", flag(modes_.flood)},
      {"_feed_override", override(EnableOverride::Kind::kFeed)},
      {"_speed_override", override(EnableOverride::Kind::kSpeed)},
      {"_adaptive_feed", override(EnableOverride::Kind::kAdaptiveFeed)},
      {"_feed_hold", override(EnableOverride::Kind::kFeedHold)},
      {"_current_tool", static_cast<double>(modes_.tool)},
      {"_selected_tool", static_cast<double>(modes_.selected_tool)},
      // The pocket of a tool has its number.
      {"_current_pocket", static_cast<double>(modes_.tool)},
      {"_selected_pocket", static_cast<double>(modes_.selected_tool)},
      {"_tool_offset", flag(has_tool_offset())},
      {"_ijk_absolute_mode", flag(modes_.absolute_centres)},
      {"_retract_old_z", flag(modes_.retract_to_start)},
      {"_retract_r_plane", flag(!modes_.retract_to_start)},
      {"_spindle_css_mode", flag(modes_.surface_most_rpm > 0.0)},
      {"_spindle_rpm_mode", flag(modes_.surface_most_rpm == 0.0)},
      // What this interpreter does not have.
      {"_ccomp", kNoCompensationCode},
      {"_lathe_diameter_mode", 0.0},
      {"_lathe_radius_mode", 1.0},
      {"_units_per_rev", 0.0},
      {"_remap_level", 0.0},
      {"_task", 0.0},
      {"_u", 0.0},
      {"_v", 0.0},
      {"_w", 0.0},
      // The language is that of LinuxCNC 2.9, on a machine in mm.
      {"_vmajor", 2.9},
      {"_vminor", 0.0},
      {"_metric_machine", 1.0},
  };
  for (const auto& one : values) {
    if (one.name == name) return one.value;
  }
  return std::nullopt;
}

}  // namespace armature::gcode
