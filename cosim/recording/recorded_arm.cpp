#include "cosim/recording/recorded_arm.hpp"

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "cosim/recording/recorded_frame.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

// What is written from it has the same bytes on every machine, so the sines are not those of the C library.
Eigen::Isometry3d turn(double angle_deg, Eigen::Index from, Eigen::Index to) {
  const auto [s, c] = math::sin_cos(angle_deg * kRadPerDeg);
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned(from, from) = turned(to, to) = c;
  turned(to, from) = s;
  turned(from, to) = -s;
  return turned;
}

}  // namespace

std::optional<RecordedArm> RecordedArm::of(const Json& summary) {
  const Json arm = summary.value("arm", Json(nullptr));
  if (!arm.is_object() || !arm.contains("links") || !arm["links"].is_array()) return std::nullopt;
  RecordedArm recorded;
  for (const Json& link : arm["links"]) {
    const Eigen::Translation3d shift{link["a_mm"].get<double>(), 0.0, link["d_mm"].get<double>()};
    recorded.links_.push_back({.sign = link["sign"].get<double>(),
                               .offset_deg = link["offset_deg"].get<double>(),
                               .end = shift * turn(link["alpha_deg"].get<double>(), 1, 2)});
  }
  recorded.flange_T_tool_ = isometry_of(recorded_pose(arm["tool"]));
  return recorded;
}

Eigen::Isometry3d RecordedArm::link(std::size_t joint, double angle_deg) const {
  const Link& link = links_[joint];
  return turn(link.sign * angle_deg + link.offset_deg, 0, 1) * link.end;
}

Eigen::Isometry3d RecordedArm::tool(std::span<const double> angles_deg) const {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < links_.size(); ++i) frame = frame * link(i, angles_deg[i]);
  return frame * flange_T_tool_;
}

}  // namespace armature::cosim
