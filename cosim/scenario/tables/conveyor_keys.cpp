// [conveyor] and [[conveyor.speed]].
#include <cmath>
#include <string>

#include "cosim/scenario/moves/pose.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxBeltSpeed = 10'000;
constexpr double kMaxBeltAccel = 1'000'000;

std::string check_belt_axes(ConveyorSpec&, const KeyContext& context) {
  const RobotSpec* robot = context.robot.spec;
  if (robot == nullptr || robot->axis_count == kAxes) return {};
  return "needs a robot with six axes, this one has " + std::to_string(robot->axis_count);
}

std::string check_belt_direction(ConveyorSpec& conveyor, const KeyContext&) {
  const auto& [x, y, z] = conveyor.direction;
  return x == 0 && y == 0 && z == 0 ? "expected a direction, found [0, 0, 0]" : std::string{};
}

std::string check_belt_window(ConveyorSpec& conveyor, const KeyContext&) {
  if (conveyor.window_mm[0] < conveyor.window_mm[1]) return {};
  return "expected an end above the start " + number_text(conveyor.window_mm[0]) + ", found " +
         number_text(conveyor.window_mm[1]);
}

// A steeper wave would move the belt back.
std::string check_belt_wave(ConveyorSpec& conveyor, const KeyContext&) {
  constexpr double kSteepest = 0.1;
  if (conveyor.wave_mm <= kSteepest * conveyor.wave_length_mm) return {};
  return "expected at most a tenth of wave_length_mm = " + number_text(conveyor.wave_length_mm) + ", found " +
         number_text(conveyor.wave_mm);
}

std::string check_belt_parts(ConveyorSpec& conveyor, const KeyContext& context) {
  for (std::size_t i = 0; i < conveyor.part_s.size(); ++i) {
    if (std::string why = outside_run(conveyor.part_s[i], *context.scenario); !why.empty()) return why;
    if (i > 0 && conveyor.part_s[i] <= conveyor.part_s[i - 1]) {
      return "expected more than " + number_text(conveyor.part_s[i - 1]) + ", the time before, found " +
             number_text(conveyor.part_s[i]);
    }
  }
  return {};
}

// `speed` is the last one of the list so far.
std::string check_belt_order(const BeltSpeedSpec& speed, const KeyContext& context) {
  if (std::string why = outside_run(speed.at_s, *context.scenario); !why.empty()) return why;
  const std::vector<BeltSpeedSpec>& all = context.scenario->conveyor->speeds;
  if (all.size() < 2 || speed.at_s > all[all.size() - 2].at_s) return {};
  return "expected more than " + number_text(all[all.size() - 2].at_s) + ", the time of the change before, found " +
         number_text(speed.at_s);
}

const KeyTable<BeltSpeedSpec>& belt_speed_keys() {
  static const KeyTable<BeltSpeedSpec> kTable{
      .text = "Each table changes the speed of the belt, in the order of time.",
      .keys = {
          at_key<BeltSpeedSpec>("Time at which the change begins.").checked(check_belt_order),
          key("speed_mm_s", &BeltSpeedSpec::speed_mm_s, between(-kMaxBeltSpeed, kMaxBeltSpeed, "mm/s"),
              "New speed. 0 stops the belt, a negative one moves it back.")
              .required(),
      }};
  return kTable;
}

std::string check_hidden_time(BeltCameraSpec& camera, const KeyContext&) {
  if (camera.hidden_s[0] <= camera.hidden_s[1]) return {};
  return "expected an end that is not before the start " + number_text(camera.hidden_s[0]) + ", found " +
         number_text(camera.hidden_s[1]);
}

const KeyTable<BeltCameraSpec>& belt_camera_keys() {
  static const KeyTable<BeltCameraSpec> kTable{
      .text =
          "A camera measures where the belt is, instead of an encoder. The belt may then be a target that a hand moves "
          "along a line. Its times are in whole ticks of 0.05 ms. The controller knows them.",
      .keys = {
          key("period_ms", &BeltCameraSpec::period_ms, between(0.05, 1'000, "ms"), "Time between two samples."),
          key("dead_time_ms", &BeltCameraSpec::dead_time_ms, between(0, 1'000, "ms"),
              "Time from the moment that a sample shows until the controller has it."),
          key("noise_mm", &BeltCameraSpec::noise_mm, between(0, 100, "mm"),
              "Standard deviation of a sample, drawn with `seed` of the scenario."),
          key("hidden_s", &BeltCameraSpec::hidden_s, between(0, kMaxDurationS, "s"),
              "From the first time to the second one the target is hidden: no sample is taken. More than three "
              "missing in a row stop the arm. `[0, 0]`: never.")
              .checked(check_hidden_time),
      }};
  return kTable;
}

std::string check_policy_variant(BeltPolicySpec&, const KeyContext& context) {
  return context.scenario->variant == Variant::kPaper ? "the logic of variant = \"paper\" has no network"
                                                      : std::string{};
}

const KeyTable<BeltPolicySpec>& belt_policy_keys() {
  static const KeyTable<BeltPolicySpec> kTable{
      .text =
          "A network of 8-bit integers corrects where the belt is expected when the set-points are executed. "
          "`armature train` makes its file, which states the largest correction. There is no correction while "
          "the belt is outside the ranges of training.",
      .keys = {
          key("file", &BeltPolicySpec::file_name, anything(), "File of the network, relative to the scenario file.")
              .required()
              .checked(check_policy_variant),
          named_key("on", &BeltPolicySpec::on,
                    "What computes it, with the same results: `logic`: the block policy_mlp, `arm`: core 0."),
          key("percent", &BeltPolicySpec::percent, between(0, 100, "percent"),
              "Largest correction, as a share of that of the file. 0: none."),
      }};
  return kTable;
}

}  // namespace

const KeyTable<ConveyorSpec>& conveyor_keys() {
  static const KeyTable<ConveyorSpec> kTable{
      .text =
          "A conveyor belt beside a six-axis arm. Paths with `frame = \"conveyor\"` are executed in the frame of a "
          "part on the belt. The first one waits until the part enters the window. The arm then accelerates to the "
          "velocity of the belt, executes these paths and the commands for pins between them, and leaves the part for "
          "the first move in another frame. The host sends the count of the belt's encoder to the controller in each "
          "tick, as a fieldbus does, because the six decoders of the logic belong to the axes.",
      .keys =
          {
              key("xyz_mm", &ConveyorSpec::xyz_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"),
                  "Position of a part at the sync point in the base frame: the origin of the frame `conveyor`.")
                  .required()
                  .checked(check_belt_axes),
              key("rpy_deg", &ConveyorSpec::rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "Orientation of a part in the base frame: rotations about the fixed x, then y, then z axis."),
              key("direction", &ConveyorSpec::direction, between(-kMaxPlaceMm, kMaxPlaceMm),
                  "Direction of the belt in the base frame, of any length.")
                  .checked(check_belt_direction),
              key("window_mm", &ConveyorSpec::window_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"),
                  "Window in which the arm may follow a part: distances of the part from the sync point, along the "
                  "belt, at the start and at the end.")
                  .required()
                  .checked(check_belt_window),
              key("part_s", &ConveyorSpec::part_s, between(0, kMaxDurationS, "s"),
                  "Times at which parts pass the sync point, in ascending order. At each of them the controller gets "
                  "the count of the encoder.")
                  .checked(check_belt_parts),
              key("mm_per_count", &ConveyorSpec::mm_per_count, above(0, 10, "mm"),
                  "Distance that the belt moves for one count of its encoder."),
              key("max_speed_mm_s", &ConveyorSpec::max_speed_mm_s, above(0, kMaxBeltSpeed, "mm/s"),
                  "Largest speed of a belt that the arm follows."),
              key("accel_mm_s2", &ConveyorSpec::accel_mm_s2, above(0, kMaxBeltAccel, "mm/s^2"),
                  "Acceleration with which the tool takes up the velocity of the belt, follows its changes and leaves "
                  "it. It adds to that of the path. Its jerk has no limit."),
              key("speed_tolerance_percent", &ConveyorSpec::speed_tolerance_percent, between(0, 50, "percent"),
                  "Before a path begins, it is checked for belts that are faster and slower by this share."),
              key("lead_ms", &ConveyorSpec::lead_ms, between(0, 100, "ms"),
                  "Time by which the set-points are ahead of the part, because the drives lag behind them. The lag of "
                  "the position loop is `damping` / (pi `natural_hz`)."),
              key("speed_mm_s", &ConveyorSpec::speed_mm_s, between(0, kMaxBeltSpeed, "mm/s"),
                  "Speed of the belt at the start."),
              key("belt_accel_mm_s2", &ConveyorSpec::belt_accel_mm_s2, above(0, kMaxBeltAccel, "mm/s^2"),
                  "Acceleration of the belt when its speed changes."),
              key("wave_mm", &ConveyorSpec::wave_mm, between(0, 100, "mm"),
                  "Amplitude of an error of the position of the belt that repeats with each turn of its drum.")
                  .checked(check_belt_wave),
              key("wave_length_mm", &ConveyorSpec::wave_length_mm, above(0, kMaxPlaceMm, "mm"),
                  "Distance that the belt moves in one turn of its drum."),
          },
      .tables = {tables("speed", &ConveyorSpec::speeds, belt_speed_keys()),
                 table("camera", &ConveyorSpec::camera, belt_camera_keys()),
                 table("policy", &ConveyorSpec::policy, belt_policy_keys())}};
  return kTable;
}

}  // namespace armature::cosim
