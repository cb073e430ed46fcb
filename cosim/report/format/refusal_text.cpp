#include "cosim/report/format/refusal_text.hpp"

#include <fmt/format.h>

#include "controller/base/angle_units.hpp"
#include "controller/base/timebase.hpp"
#include "controller/kinematics/ik_result.hpp"
#include "controller/trajectory/grid/chain_law.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

std::string singularities(std::uint8_t mask) {
  std::string text;
  for (const std::string_view name : singularity_names(mask)) text.append(text.empty() ? ": " : " and ").append(name);
  return text.empty() ? text : text + " singularity";
}

// `elbow and number of turns of joint 6`; `axis`: the joint with other turns.
std::string parts_text(std::uint8_t mask, std::uint8_t axis) {
  std::string text;
  for (const std::string_view name : configuration_part_names(mask)) {
    text.append(text.empty() ? "" : " and ").append(name == "turns" ? "number of turns" : name);
    if (name == "turns" && axis != 0) text.append(" of ").append(mover_name(axis));
  }
  return text;
}

// Which move of a chain the path belongs to.
std::string chain_move(const PathProblem& path) {
  return path.segment == 0 ? std::string{} : fmt::format(" of move {} of its chain", path.segment + 1);
}

std::string place(const PathProblem& path) {
  return fmt::format(" at {:.0f} % of the path", 100 * path.at) + chain_move(path);
}

// `path.at` is where the shortfall begins; `amount` is the largest one of the path.
std::string shortfall(std::string_view amount, const PathProblem& path) {
  if (path.at >= 1) return fmt::format("by {} at the end of the path{}", amount, chain_move(path));
  return fmt::format("by up to {} from {:.0f} % of the path on{}", amount, 100 * path.at, chain_move(path));
}

// With so many digits that both differ.
std::string beyond_text(double angle_deg, double limit_deg) {
  std::string angle, limit;
  for (int digits = 6; digits <= 17 && angle == limit; ++digits) {
    angle = fmt::format("{:.{}g}", angle_deg, digits);
    limit = fmt::format("{:.{}g}", limit_deg, digits);
  }
  return fmt::format("{} deg is beyond {} deg", angle, limit);
}

// `, axis 2: target 200 deg is beyond 165 deg`
std::string outside_text(const MoveRefused& refusal) {
  const PathProblem& path = refusal.path;
  const double angle_deg = path.angle_rad * kDegPerRad, limit_deg = path.limit_rad * kDegPerRad;
  const bool on_path = path.kind != PathProblem::Kind::kNone;
  std::string text = fmt::format(", axis {}{}: ", refusal.axis, on_path ? place(path) : std::string{});
  if (angle_deg == limit_deg) return text + fmt::format("it would pass {:.6g} deg between two set-points", limit_deg);
  if (!on_path) text += path.at >= 1 ? "target " : "no room to brake, ";
  return text + beyond_text(angle_deg, limit_deg);
}

}  // namespace

std::string refusal_text(const MoveRefused& refusal) {
  const std::string_view name = word_of(refusal.reason);
  const PathProblem& path = refusal.path;
  switch (path.kind) {
    case PathProblem::Kind::kNone:
      break;
    case PathProblem::Kind::kNoCircle:
      return fmt::format("{}: the three points lie on a line or coincide, or the start is on the axis", name);
    case PathProblem::Kind::kOutputOutside:
      return fmt::format("{}: an output is before the start or behind the end of the path{}", name, chain_move(path));
    case PathProblem::Kind::kNoSpline:
      return fmt::format("{}: points of the spline are closer than {:g} mm, or the curve turns back on the spot{}",
                         name, Spline::kClosest_mm, chain_move(path));
    case PathProblem::Kind::kUnreachable:
      return fmt::format("{} {}", name, shortfall(fmt::format("{:.3g} mm", path.margin_mm), path));
    case PathProblem::Kind::kOutsideLimits:
      break;
    case PathProblem::Kind::kOrientation:
      return fmt::format("{} off {}: five joints hold the hand in a vertical plane through axis 1", name,
                         shortfall(fmt::format("{:.3g} deg", path.residual_rad * kDegPerRad), path));
    case PathProblem::Kind::kTooFast:
      return fmt::format("{}: {} would need {:.3g} times the time{}{}", name, mover_name(path.axis), path.stretch,
                         place(path), singularities(path.singular));
    case PathProblem::Kind::kTooLong:
      return fmt::format("{}: the path would take more than {:.0f} s{}; make it faster or divide it", name,
                         seconds(kLongestSegment), chain_move(path));
    case PathProblem::Kind::kTooManySegments:
      return fmt::format("{}: more moves in one chain than a plan holds", name);
    case PathProblem::Kind::kInvalidLimits:
      return fmt::format("{}: a limit of the tool is not above 0{}", name, chain_move(path));
    case PathProblem::Kind::kNoConfiguration:
      return fmt::format("{}: no solution has the requested {}", name, parts_text(path.configuration, 0));
    case PathProblem::Kind::kOtherConfiguration:
      return fmt::format("{}: the path{} ends with another {} than requested; move the joints there first", name,
                         chain_move(path), parts_text(path.configuration, path.axis));
    case PathProblem::Kind::kInvalidPose:
      return fmt::format("{}: no pose{}", name, place(path));
  }
  if (refusal.reason == Refusal::kOutsideLimits && refusal.axis != 0) return std::string{name} + outside_text(refusal);
  return refusal.axis == 0 ? std::string{name} : fmt::format("{}, axis {}", name, refusal.axis);
}

}  // namespace armature::cosim
