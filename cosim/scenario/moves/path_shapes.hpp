// The types `line`, `arc`, `circle`, `arc_about` and `spline` of [[move]].
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "controller/message/command.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/moves/path.hpp"

namespace armature::cosim {

struct LineSpec {
  PathSpec path{};
};

template <>
[[nodiscard]] inline const MoveEntry<LineSpec>& move_entry<LineSpec>() {
  static const MoveEntry<LineSpec> kEntry{
      .name = "line",
      .command = [](const LineSpec& move, Tag tag) -> Command {
        return to_cartesian_move(SegmentRequest::Kind::kLine, move.path, {}, tag);
      },
      .text = "moves the tool on a straight line",
      .queued = true,
      .keys = keys_of_path<LineSpec>(),
  };
  return kEntry;
}

struct ArcSpec {
  PathSpec path{};
  std::array<double, 3> via_mm{};  // second point
};

template <>
[[nodiscard]] inline const MoveEntry<ArcSpec>& move_entry<ArcSpec>() {
  static const MoveEntry<ArcSpec> kEntry{
      .name = "arc",
      .command = [](const ArcSpec& move, Tag tag) -> Command {
        return to_cartesian_move(SegmentRequest::Kind::kArc, move.path, move.via_mm, tag);
      },
      .text = "moves the tool on an arc",
      .queued = true,
      .keys = keys_of_path_via<ArcSpec>(),
  };
  return kEntry;
}

struct CircleSpec {
  PathSpec path{};
  std::array<double, 3> via_mm{};  // second point
};

template <>
[[nodiscard]] inline const MoveEntry<CircleSpec>& move_entry<CircleSpec>() {
  static const MoveEntry<CircleSpec> kEntry{
      .name = "circle",
      .command = [](const CircleSpec& move, Tag tag) -> Command {
        return to_cartesian_move(SegmentRequest::Kind::kCircle, move.path, move.via_mm, tag);
      },
      .text = "moves the tool once around a circle",
      .queued = true,
      .keys = keys_of_path_via<CircleSpec>(),
  };
  return kEntry;
}

struct ArcAboutSpec {
  PathSpec path{};  // its pose has only an orientation and a frame
  std::array<double, 3> center_mm{};
  std::array<double, 3> axis{0, 0, 1};
  double angle_deg = 360;
  double advance_mm = 0;
};

template <>
[[nodiscard]] inline const MoveEntry<ArcAboutSpec>& move_entry<ArcAboutSpec>() {
  constexpr std::string_view kPlace = "center_mm";
  constexpr double kMaxTurnsDeg = 360 * kMaxRevolutions;
  constexpr auto kCheckAxis = [](ArcAboutSpec& move, const KeyContext&) -> std::string {
    return move.axis == std::array<double, 3>{} ? "expected a direction, found 0, 0, 0" : "";
  };
  constexpr auto kCheckAngle = [](ArcAboutSpec& move, const KeyContext&) -> std::string {
    return move.angle_deg == 0 ? "expected an angle other than 0" : "";
  };
  static const MoveEntry<ArcAboutSpec> kEntry = [&] {
    MoveEntry<ArcAboutSpec> entry{
        .name = "arc_about",
        .command = [](const ArcAboutSpec& arc, Tag tag) -> Command {
          CartesianMove about = to_cartesian_move(SegmentRequest::Kind::kArcAbout, arc.path, arc.center_mm, tag);
          about.about = {
              .axis = to_vector(arc.axis), .angle_rad = arc.angle_deg * kRadPerDeg, .advance_mm = arc.advance_mm};
          return about;
        },
        .text = "moves the tool around an axis by an angle: on an arc, a circle or, with `advance_mm`, a helix",
        .queued = true,
        .keys = {key(kPlace, &ArcAboutSpec::center_mm, target_place(),
                     "A point of the axis, for example the centre of the circle. The circle passes the start of the "
                     "move, and its plane is at a right angle to the axis.")
                     .required()
                     .needs(Needs::kKinematics),
                 key("axis", &ArcAboutSpec::axis, target_place(),
                     "Direction of the axis in the frame, of any length: [0, 0, 1] is its z axis.")
                     .checked(kCheckAxis),
                 key("angle_deg", &ArcAboutSpec::angle_deg, between(-kMaxTurnsDeg, kMaxTurnsDeg, "deg"),
                     "Angle around the axis, right-handed where it is above 0. More than 360 means several turns.")
                     .checked(kCheckAngle),
                 key("advance_mm", &ArcAboutSpec::advance_mm, target_place(),
                     "Distance along the axis during the whole move.")}};
    entry.keys.append(keys_of_path_from<ArcAboutSpec>(kPlace));
    return entry;
  }();
  return kEntry;
}

struct SplineSpec {
  PathSpec path{};
  std::vector<std::array<double, 3>> through_mm{};  // points between its start and its end
};

template <>
[[nodiscard]] inline const MoveEntry<SplineSpec>& move_entry<SplineSpec>() {
  static const MoveEntry<SplineSpec> kEntry = [] {
    MoveEntry<SplineSpec> entry{.name = "spline",
                                .command = [](const SplineSpec& spline, Tag tag) -> Command {
                                  CartesianMove curve =
                                      to_cartesian_move(SegmentRequest::Kind::kSpline, spline.path, {}, tag);
                                  curve.through.count = static_cast<std::uint8_t>(spline.through_mm.size());
                                  std::ranges::transform(spline.through_mm, curve.through.mm.begin(), to_vector);
                                  return curve;
                                },
                                .text = "moves the tool on a smooth curve through points",
                                .queued = true,
                                .keys = keys_of_path<SplineSpec>()};
    Rule rule = target_place();
    rule.most_rows = ThroughPoints::kMax;
    entry.keys.push_back(
        key("through_mm", &SplineSpec::through_mm, rule,
            "Points that the tool centre point passes exactly between its start and `xyz_mm`, in this order. The curve "
            "is a cubic spline over the sum of the distances between the points, without curvature at both ends. A "
            "chain has at most 4 splines: the tool stops before the fifth.")
            .required()
            .checked([](SplineSpec& spline, const KeyContext&) -> std::string {
              if (spline.path.pose.frame == kConveyorFrame.index) return "a spline cannot move with the conveyor";
              const bool tangent = spline.path.orientation == CartesianMove::Orientation::kTangent;
              return tangent ? "a spline has no orientation \"tangent\"" : "";
            }));
    return entry;
  }();
  return kEntry;
}

}  // namespace armature::cosim
