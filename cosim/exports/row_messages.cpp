#include "cosim/exports/row_messages.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <iterator>

#include "controller/base/angle_units.hpp"
#include "controller/base/axes.hpp"
#include "cosim/exports/mcap_channels.hpp"
#include "cosim/recording/recorded_frame.hpp"

namespace armature::cosim {
namespace {

constexpr double kMPerMm = 1e-3;
constexpr std::uint64_t kTransformsEveryNs = 10'000'000;  // frames of links are for the eye

// {"x": ..., "y": ..., "z": ...} in m.
std::string point_text(const Eigen::Vector3d& mm) {
  return fmt::format(R"({{"x":{},"y":{},"z":{}}})", mm.x() * kMPerMm, mm.y() * kMPerMm, mm.z() * kMPerMm);
}

std::string rotation_text(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q{rotation};
  return fmt::format(R"({{"x":{},"y":{},"z":{},"w":{}}})", q.x(), q.y(), q.z(), q.w());
}

std::string transform_text(const std::string& time, const std::string& parent, const std::string& child,
                           const Eigen::Isometry3d& pose) {
  return fmt::format(R"({{"timestamp":{},"parent_frame_id":{},"child_frame_id":{},"translation":{},"rotation":{}}})",
                     time, Json(parent).dump(), Json(child).dump(), point_text(pose.translation()),
                     rotation_text(pose.linear()));
}

// Columns of both cores; empty if one is missing or has other rows.
std::vector<const NumberColumn*> of_cores(const TraceTable& load, std::size_t rows, const char* suffix) {
  std::vector<const NumberColumn*> columns;
  for (int core = 0; core < 2; ++core) {
    const NumberColumn* const column = load.find(fmt::format("core{}_{}", core, suffix));
    if (column == nullptr || column->values.size() != rows) return {};
    columns.push_back(column);
  }
  return columns;
}

}  // namespace

RowMessages::RowMessages(const RunRecord& run, const std::optional<TraceTable>& load)
    : times_{run.trace},
      rows_{run.trace.rows()},
      sides_{{run.axis_columns("enc_deg"), kJointStates, kToolPose},
             {run.axis_columns("ref_deg"), kJointSetPoints, kToolSetPoint}},
      arm_{RecordedArm::of(run.summary)} {
  for (const RecordedFrame& frame : recorded_frames(run.summary)) {
    frames_ += transform_text(time_text(0), "base", frame.name, isometry_of(frame.base_T_frame)) + ",";
  }
  if (!load) return;
  load_ = {of_cores(*load, rows_, "awake_cycles"), of_cores(*load, rows_, "bus_cycles")};
  if (load_[0].empty() || load_[1].empty()) load_.clear();
}

void RowMessages::write(std::size_t row, McapWriter& writer) const {
  const std::uint64_t now = time_ns(row);
  for (const Side& side : sides_) {
    writer.write(side.joints_channel, now, joints_text(side, row));
    if (arm_) writer.write(side.tool_channel, now, tool_text(side, row));
  }
  const bool new_picture = row == 0 || now / kTransformsEveryNs != time_ns(row - 1) / kTransformsEveryNs;
  if (arm_ && new_picture) writer.write(kTransforms, now, transforms_text(row));
  if (!load_.empty()) writer.write(kCoreLoad, now, load_text(row));
}

std::string RowMessages::time_text(std::size_t row) const {
  const std::uint64_t ns = time_ns(row);
  return fmt::format(R"({{"sec":{},"nsec":{}}})", ns / kNsPerSecond, ns % kNsPerSecond);
}

// From the row before to the one behind.
double RowMessages::speed_deg_s(const NumberColumn& angle, std::size_t row) const {
  const std::size_t first = row == 0 ? 0 : row - 1;
  const std::size_t last = row + 1 == rows_ ? row : row + 1;
  const auto ns = static_cast<double>(time_ns(last) - time_ns(first));
  return ns == 0 ? 0 : (angle.number(last) - angle.number(first)) / ns * static_cast<double>(kNsPerSecond);
}

std::string RowMessages::joints_text(const Side& side, std::size_t row) const {
  std::string text = R"({"timestamp":)" + time_text(row) + R"(,"joints":[)";
  for (std::size_t i = 0; i < side.angles.size(); ++i) {
    const NumberColumn& angle = *side.angles[i];
    fmt::format_to(std::back_inserter(text), R"({}{{"name":"joint{}","position":{},"velocity":{}}})", i == 0 ? "" : ",",
                   i + 1, angle.number(row) * kRadPerDeg, speed_deg_s(angle, row) * kRadPerDeg);
  }
  return text + "]}";
}

std::string RowMessages::tool_text(const Side& side, std::size_t row) const {
  PerAxis<double> angles{};
  for (std::size_t i = 0; i < side.angles.size(); ++i) angles[i] = side.angles[i]->number(row);
  const Eigen::Isometry3d pose = arm_->tool(angles);
  return fmt::format(R"({{"timestamp":{},"frame_id":"base","pose":{{"position":{},"orientation":{}}}}})",
                     time_text(row), point_text(pose.translation()), rotation_text(pose.linear()));
}

std::string RowMessages::transforms_text(std::size_t row) const {
  const std::string time = time_text(row);
  std::string text = R"({"transforms":[)" + (row == 0 ? frames_ : "");
  std::string parent = "base";
  for (std::size_t i = 0; i < arm_->joints(); ++i) {
    const std::string child = i + 1 == arm_->joints() ? "flange" : fmt::format("link{}", i + 1);
    text += transform_text(time, parent, child, arm_->link(i, sides_[0].angles[i]->number(row))) + ",";
    parent = child;
  }
  return text + transform_text(time, parent, "tool", arm_->flange_T_tool()) + "]}";
}

std::string RowMessages::load_text(std::size_t row) const {
  return fmt::format(R"({{"timestamp":{},"awake_cycles":[{},{}],"bus_cycles":[{},{}]}})", time_text(row),
                     load_[0][0]->values[row], load_[0][1]->values[row], load_[1][0]->values[row],
                     load_[1][1]->values[row]);
}

}  // namespace armature::cosim
