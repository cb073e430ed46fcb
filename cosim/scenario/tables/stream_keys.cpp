// [[stream]]: set-points of a client that sends them at a fixed rate.
#include <string>

#include "cosim/scenario/moves/entry.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {
namespace {

std::string check_stream_profile(const StreamSpec& stream, const KeyContext& context) {
  const RobotSpec* robot = context.robot.spec;
  if (stream.profile != ProfileKind::kSCurve || robot == nullptr) return {};
  for (std::size_t i = 0; i < robot->axis_count; ++i) {
    if (!robot->axes[i].max_jerk_deg_s3) return "needs max_jerk_deg_s3 of every axis of the robot";
  }
  return {};
}

}  // namespace

const KeyTable<StreamSpec>& stream_keys() {
  static const KeyTable<StreamSpec> kTable{
      .text =
          "Each table is a stream of set-points that a client sends one by one, each at its time, as ros2_control, "
          "EtherCAT CSP or a learned policy would. It begins when the arm stands at the end of all moves, otherwise it "
          "is refused.",
      .keys = {
          at_key<StreamSpec>("Time at which the first set-point is sent."),
          key("file", &StreamSpec::file_name, anything(), "CSV file of the set-points, relative to the scenario file.")
              .required(),
          key("delay_ms", &StreamSpec::delay_ms, above(0, kMaxStreamDelayMs, "ms"),
              "The arm follows the stream this much later than the first set-point came. A set-point that is not there "
              "when it is needed stops the arm. At least twice the interval of the set-points gives the smoothest "
              "motion.")
              .without("2.5 times the longest interval of the file"),
          profile_key(&StreamSpec::profile,
                      "Limits of each axis while it follows: `trapezoid`: speed and acceleration, `scurve`: also jerk.")
              .checked(check_stream_profile),
      }};
  return kTable;
}

}  // namespace armature::cosim
