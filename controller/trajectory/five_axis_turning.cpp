#include "controller/trajectory/five_axis_turning.hpp"

#include <cmath>
#include <numbers>

#include "controller/core/math.hpp"
#include "controller/kinematics/turns.hpp"
#include "controller/trajectory/orientation_path.hpp"

namespace armature {
namespace {

constexpr double kRounding = 1e-12;      // sines, and lengths as a share of the length
constexpr double kHalfTurn_rad = 1e-14;  // as in turn(): rounding does not decide the way

double shorter_way(double from_rad, double to_rad) {
  const double way = wrapped(to_rad - from_rad);
  return std::fabs(way) >= std::numbers::pi - kHalfTurn_rad ? std::fabs(way) : way;
}

// A line in the plane that the tool is in, from one side of axis 1 to the other, with a turn that stays in the plane.
bool passes_axis_1(const CartesianSegment& segment, const ArmPlane& plane, const Transform& from, const Transform& to) {
  if (segment.path.shape != PositionPath::Shape::kLine) return false;
  const math::SinCos heading = math::sin_cos(plane.heading_rad(from));
  const Eigen::Vector3d outwards{heading.cos, heading.sin, 0.0}, normal{-heading.sin, heading.cos, 0.0};
  if (outwards.dot(from.position_mm) * outwards.dot(to.position_mm) > 0.0) return false;
  const OrientationPath& turn = segment.orientation;
  const Eigen::Vector3d axis = turn.start * turn.axis;
  const bool turns_in_plane = turn.angle_rad <= kRounding || (axis - axis.dot(normal) * normal).norm() <= kRounding;
  return turns_in_plane &&
         std::fabs(normal.dot(to.position_mm - from.position_mm)) <= kRounding * segment.path.length_mm;
}

}  // namespace

TurningEnd lay_out_turning(CartesianSegment& segment, const ArmPlane& plane, const Transform& from,
                           const Transform& to) noexcept {
  segment.orientation = turn(from.rotation, to.rotation);
  const int upright = plane.upright(from);
  if (upright != 0 && plane.upright(to) == upright) {
    // Vertical to rounding it is in every plane, and nothing has to be changed; also not where the heading is open.
    if (plane.tilt(from) <= kRounding && plane.tilt(to) <= kRounding) return {.base_T_tool = to};
    segment.turning = Turning::kUpright;
    const HeldTool end = into_plane(to, plane.flange_T_tool());
    return {.base_T_tool = end.base_T_tool,
            .residual_rad = turn(to.rotation, end.base_T_tool.rotation).angle_rad,
            .missing_mm = end.missing_mm};
  }
  if (passes_axis_1(segment, plane, from, to)) return {.base_T_tool = to};

  const PlaneAngles start = plane.nearest(from).angles;
  const ArmPlane::Nearest nearest = plane.nearest(to);
  segment.turning = Turning::kFollowing;
  segment.orientation = {};
  segment.plane_turn = {.start = start,
                        .way = {.pitch_rad = shorter_way(start.pitch_rad, nearest.angles.pitch_rad),
                                .roll_rad = shorter_way(start.roll_rad, nearest.angles.roll_rad)}};
  const HeldTool end = hold_tool(nearest.angles, to.position_mm, plane.flange_T_tool());
  return {.base_T_tool = end.base_T_tool, .residual_rad = nearest.residual_rad, .missing_mm = end.missing_mm};
}

}  // namespace armature
