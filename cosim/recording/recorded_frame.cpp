#include "cosim/recording/recorded_frame.hpp"

#include <utility>

#include "controller/base/angle_units.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

Transform recorded_pose(const Json& pose) {
  const Json& at = pose["xyz_mm"];
  const Json& turn = pose["rpy_deg"];
  const auto angle = [&](std::size_t i) { return turn.at(i).get<double>() * kRadPerDeg; };
  return {.rotation = rotation_from_rpy(angle(0), angle(1), angle(2)),
          .position_mm = {at.at(0).get<double>(), at.at(1).get<double>(), at.at(2).get<double>()}};
}

Eigen::Isometry3d isometry_of(const Transform& pose) {
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() = pose.rotation;
  isometry.translation() = pose.position_mm;
  return isometry;
}

std::vector<RecordedFrame> recorded_frames(const Json& summary) {
  std::vector<RecordedFrame> frames;
  const auto list = summary.find("frames");
  if (list == summary.end() || !list->is_array()) return frames;
  for (const Json& one : *list) {
    frames.push_back({.name = one["name"].get<std::string>(), .base_T_frame = recorded_pose(one)});
  }
  return frames;
}

std::optional<RecordedFrame> recorded_program_frame(const Json& summary) {
  const auto name = summary.find("program_frame");
  if (name == summary.end() || !name->is_string()) return std::nullopt;
  for (RecordedFrame& frame : recorded_frames(summary)) {
    if (frame.name == *name) return std::move(frame);
  }
  return RecordedFrame{.name = name->get<std::string>()};
}

}  // namespace armature::cosim
