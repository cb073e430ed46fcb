#include "cosim/recording/recorded_frame.hpp"

#include <utility>

#include "controller/base/angle_units.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

std::vector<RecordedFrame> recorded_frames(const Json& summary) {
  std::vector<RecordedFrame> frames;
  const auto list = summary.find("frames");
  if (list == summary.end() || !list->is_array()) return frames;
  for (const Json& one : *list) {
    const Json& at = one["xyz_mm"];
    const Json& turn = one["rpy_deg"];
    const auto angle = [&](std::size_t i) { return turn.at(i).get<double>() * kRadPerDeg; };
    frames.push_back(
        {.name = one["name"].get<std::string>(),
         .base_T_frame = {.rotation = rotation_from_rpy(angle(0), angle(1), angle(2)),
                          .position_mm = {at.at(0).get<double>(), at.at(1).get<double>(), at.at(2).get<double>()}}});
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
