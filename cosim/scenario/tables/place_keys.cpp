// The tools and user frames.
#include <string>
#include <string_view>

#include "controller/language/job/state/machine_setup.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

// The names of frames must differ. The scenario has the frames that were read so far.
std::string check_name(const FrameSpec& frame, const KeyContext& context) {
  if (frame.name.empty() || frame.name == kBaseFrameName || frame.name == kToolFrameName ||
      frame.name == kConveyorFrameName) {
    return "expected a name other than \"\", \"base\", \"tool\" and \"conveyor\", found \"" + printable(frame.name) +
           "\"";
  }
  if (!is_taken(context.scenario->frames, frame, &FrameSpec::name)) return {};
  return "there is another frame \"" + printable(frame.name) + "\"";
}

std::string check_tool(const JobToolSpec& tool, const KeyContext& context) {
  const bool taken = is_taken(context.scenario->job.tools, tool, &JobToolSpec::number);
  return taken ? "there is another table of this tool" : "";
}

Key<PoseSpec> place_key(std::string_view text) {
  return key("xyz_mm", &PoseSpec::xyz_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"), text);
}
Key<PoseSpec> turn_key(std::string_view text) {
  return key("rpy_deg", &PoseSpec::rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"), text);
}

}  // namespace

const KeyTable<PoseSpec>& tool_keys() {
  static const KeyTable<PoseSpec> kTable{
      .text = "Pose of the tool centre point in the frame of the flange.",
      .keys = {
          place_key("Position of the tool centre point in the frame of the flange."),
          turn_key(
              "Orientation of the tool in the frame of the flange: rotations about the fixed x, then y, then z axis."),
      }};
  return kTable;
}

const KeyTable<JobToolSpec>& job_tool_keys() {
  static const KeyTable<JobToolSpec> kTable{
      .text =
          "Each table is a tool that the positions of a robot program name by `///TOOL`. A number without a table is "
          "the tool that the arm carries, `[tool]`; a program may name that by one number. On a line, an arc or a "
          "curve a tool of such a table must not turn, unless its centre point is that of `[tool]`.",
      .keys = {
          key("number", &JobToolSpec::number, between(0, job::kToolNumbers - 1), "Number of the tool.")
              .required()
              .checked(check_tool),
          part(&JobToolSpec::pose, place_key("Position of its centre point in the frame of the flange.")),
          part(&JobToolSpec::pose,
               turn_key("Its orientation there: rotations about the fixed x, then y, then z axis.")),
      }};
  return kTable;
}

const KeyTable<FrameSpec>& frame_keys() {
  static const KeyTable<FrameSpec> kTable{
      .text = "Each table defines a user frame in the base frame of the robot.",
      .keys = {
          key("name", &FrameSpec::name, anything(),
              "Name of the frame for `[[move]]`. It must be unique and must not be `base`, `tool` or `conveyor`.")
              .required()
              .checked(check_name),
          part(&FrameSpec::pose, place_key("Origin of the frame in the base frame.")),
          part(&FrameSpec::pose,
               turn_key(
                   "Orientation of the frame in the base frame: rotations about the fixed x, then y, then z axis.")),
      }};
  return kTable;
}

}  // namespace armature::cosim
