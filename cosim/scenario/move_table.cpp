#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/scenario_tables.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

constexpr double kMinSpeedPercent = 0.1;  // slower moves take longer than any run
constexpr double kMinOverridePercent = 1;
constexpr double kMaxSpeed = 1e6;  // mm/s, deg/s; as the others, far beyond any arm
constexpr double kMaxAccel = 1e9;
constexpr double kMaxJerk = 1e12;
constexpr double kMaxBlendMm = 10'000;
constexpr double kMaxTimeoutS = 86'400;

MoveType type_of(std::string_view name) {
  const auto* const found = std::ranges::find(kTypeNames, name);
  return static_cast<MoveType>(found - kTypeNames.begin());  // the rule knows the same names
}

class MoveReader {
 public:
  MoveReader(TableReader& table, const ScenarioRobot& robot, const Scenario& scenario, MoveSpec& move)
      : table_{table}, robot_{robot}, scenario_{scenario}, move_{move} {}

  // Reads the keys of the move's type and refuses those of the others.
  void read() {
    const MoveType type = move_.type;
    const bool joint = type == MoveType::kJoint;
    const bool path = type == MoveType::kLine || type == MoveType::kArc || type == MoveType::kCircle;
    const bool pose = path || (joint && table_.has("xyz_mm"));
    if (joint) {
      read_target();
    } else {
      table_.refuse({"target_deg"}, "type = \"joint\"");
    }
    if (joint || type == MoveType::kOverride) {
      read_speed_percent(joint);
    } else {
      table_.refuse({"speed_percent"}, "type = \"joint\" or \"override\"");
    }
    if (pose) {
      read_pose_keys(joint ? "xyz_mm" : "type");
    } else if (joint) {
      table_.refuse({"rpy_deg", "frame"}, "xyz_mm");
    } else {
      table_.refuse({"xyz_mm", "rpy_deg", "frame"}, "type = \"joint\", \"line\", \"arc\" or \"circle\"");
    }
    if (type == MoveType::kArc || type == MoveType::kCircle) {
      table_.read("via_mm", move_.via_mm, place(), Need::kRequired);
    } else {
      table_.refuse({"via_mm"}, "type = \"arc\" or \"circle\"");
    }
    if (joint || path) {
      table_.read("profile", move_.profile, one_of({"trapezoid", "scurve"}));
    } else {
      table_.refuse({"profile"}, "type = \"joint\", \"line\", \"arc\" or \"circle\"");
    }
    if (path) {
      read_path_limits();
    } else {
      table_.refuse({"speed_mm_s", "accel_mm_s2", "jerk_mm_s3", "turn_speed_deg_s", "turn_accel_deg_s2",
                     "turn_jerk_deg_s3", "blend_mm"},
                    "type = \"line\", \"arc\" or \"circle\"");
    }
    if (joint) require_jerk_limits_of_the_robot();
    if (type == MoveType::kDout || type == MoveType::kWaitDin) {
      read_pin(table_, move_.pin, move_.level);
    } else {
      table_.refuse({"pin", "level"}, "type = \"dout\" or \"wait_din\"");
    }
    if (type == MoveType::kWaitDin) {
      table_.read("timeout_s", move_.timeout_s, above(0, kMaxTimeoutS, "s"));
    } else {
      table_.refuse({"timeout_s"}, "type = \"wait_din\"");
    }
  }

 private:
  static Rule place() { return between(-kMaxPlaceMm, kMaxPlaceMm, "mm"); }
  [[nodiscard]] bool scurve() const { return move_.profile == "scurve"; }

  void read_target() {
    const Rule angle = between(-kMaxAngleDeg, kMaxAngleDeg, "deg");
    read_per_axis(table_, "target_deg", move_.target_deg, angle, robot_);
    const bool angles = table_.has("target_deg");
    if (angles && table_.has("xyz_mm")) table_.problem("xyz_mm", "cannot stand beside target_deg");
    if (!angles && !table_.has("xyz_mm")) {
      table_.problem("target_deg", "missing, expected " +
                                       expected_array(ValueKind::kNumber, angle, robot_.axis_count()) + ", or xyz_mm");
    }
  }

  void read_speed_percent(bool joint) {
    table_.read("speed_percent", move_.speed_percent,
                between(joint ? kMinSpeedPercent : kMinOverridePercent, 100, "percent"),
                joint ? Need::kOptional : Need::kRequired);
  }

  // `reason`: the key that makes this a move to a pose.
  void read_pose_keys(std::string_view reason) {
    if (robot_.lacks_kinematics()) {
      table_.problem(reason, "a move to a pose needs [kinematics] in " + robot_.file);
    }
    table_.read("xyz_mm", move_.xyz_mm, place(), Need::kRequired);
    table_.read("rpy_deg", move_.rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"));
    std::string frame;
    if (table_.read("frame", frame, anything())) find_frame(frame);
  }

  void find_frame(const std::string& name) {
    if (name == kBaseFrameName) {
      move_.frame = 0;
      return;
    }
    if (name == kToolFrameName) {
      move_.frame = kToolFrameIndex;
      return;
    }
    std::vector<std::string_view> known{kBaseFrameName, kToolFrameName};
    for (std::size_t i = 0; i < scenario_.frames.size(); ++i) {
      if (scenario_.frames[i].name == name) {
        move_.frame = i + 1;
        return;
      }
      // A name that is given twice has been reported; it is listed once.
      if (std::ranges::find(known, scenario_.frames[i].name) == known.end()) {
        known.emplace_back(scenario_.frames[i].name);
      }
    }
    table_.problem("frame", "unknown frame \"" + printable(name) + "\"" + suggestion(name, known));
  }

  void read_path_limits() {
    table_.read("speed_mm_s", move_.speed_mm_s, above(0, kMaxSpeed, "mm/s"));
    table_.read("accel_mm_s2", move_.accel_mm_s2, above(0, kMaxAccel, "mm/s^2"));
    table_.read("turn_speed_deg_s", move_.turn_speed_deg_s, above(0, kMaxSpeed, "deg/s"));
    table_.read("turn_accel_deg_s2", move_.turn_accel_deg_s2, above(0, kMaxAccel, "deg/s^2"));
    table_.read("blend_mm", move_.blend_mm, between(0, kMaxBlendMm, "mm"));
    if (scurve()) {
      read_jerk("jerk_mm_s3", move_.jerk_mm_s3, "mm/s^3");
      read_jerk("turn_jerk_deg_s3", move_.turn_jerk_deg_s3, "deg/s^3");
    } else {
      table_.refuse({"jerk_mm_s3", "turn_jerk_deg_s3"}, "profile = \"scurve\"");
    }
  }

  void read_jerk(std::string_view key, double& jerk, std::string_view unit) {
    const Rule rule = above(0, kMaxJerk, unit);
    table_.read(key, jerk, rule);
    if (table_.has(key)) return;
    table_.problem(key, "missing, profile = \"scurve\" needs " + expected_one(ValueKind::kNumber, rule));
  }

  void require_jerk_limits_of_the_robot() {
    if (!scurve() || robot_.spec == nullptr) return;
    const std::span axes = std::span{robot_.spec->axes}.first(robot_.spec->axis_count);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (axes[i].max_jerk_deg_s3) continue;
      table_.problem("profile", "an S-curve of the joints needs max_jerk_deg_s3 of every axis in " + robot_.file +
                                    "; axis " + std::to_string(i + 1) + " has none");
      return;
    }
  }

  TableReader& table_;
  const ScenarioRobot& robot_;
  const Scenario& scenario_;
  MoveSpec& move_;
};

}  // namespace

void read_move(TableReader& table, const ScenarioRobot& robot, const Scenario& scenario, MoveSpec& move) {
  move.line = table.line();
  read_at(table, scenario.duration_s, move.at_s);
  std::string type;
  if (!table.read("type", type, one_of(kTypeNames), Need::kRequired)) {
    table.ignore_rest();
    return;
  }
  move.type = type_of(type);
  MoveReader{table, robot, scenario, move}.read();
}

}  // namespace armature::cosim
