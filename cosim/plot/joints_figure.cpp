#include "cosim/plot/joints_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cosim/plot/caption.hpp"
#include "cosim/plot/joint_colors.hpp"
#include "cosim/plot/panel.hpp"
#include "cosim/plot/svg.hpp"

namespace armature::cosim {
namespace {

struct JointCurves {
  std::vector<PlotPoint> reference, encoder, speed;
};

// The speed between two rows is drawn at the middle of their times.
std::vector<PlotPoint> slopes(const std::vector<PlotPoint>& points) {
  std::vector<PlotPoint> slopes;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const PlotPoint a = points[i - 1];
    const PlotPoint b = points[i];
    slopes.push_back({(a.x + b.x) / 2, (b.y - a.y) / (b.x - a.x)});
  }
  return slopes;
}

JointCurves curves_of(const TraceTable& trace, std::size_t joint) {
  const NumberColumn& time = trace.column("time_s");
  const NumberColumn& reference = trace.column(fmt::format("j{}_ref_deg", joint + 1));
  const NumberColumn& encoder = trace.column(fmt::format("j{}_enc_deg", joint + 1));
  JointCurves curves;
  for (std::size_t row = 0; row < trace.rows(); ++row) {
    curves.reference.push_back({time.number(row), reference.number(row)});
    curves.encoder.push_back({time.number(row), encoder.number(row)});
  }
  curves.speed = slopes(curves.reference);
  return curves;
}

// The range of all curves that `of` selects, a little wider, on round numbers.
template <class Select>
AxisScale scale_of(const std::vector<JointCurves>& joints, Select of) {
  constexpr double kMargin = 0.03;
  constexpr int kMarks = 8;
  double low = 0;
  double high = 0;
  for (const JointCurves& joint : joints) {
    for (const PlotPoint point : of(joint)) {
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
  }
  const double margin = (high - low) * kMargin;
  return round_scale(low - margin, high + margin, kMarks);
}

// From 0. The last row of a run is a little before its end, which has a mark all the same.
AxisScale time_scale(double last_s) {
  constexpr int kMarks = 10;
  constexpr double kLittle = 0.05;  // of a step
  AxisScale scale = exact_scale(0, last_s, kMarks);
  const double whole = std::ceil(last_s / scale.step) * scale.step;
  if (whole - last_s < kLittle * scale.step) scale.high = whole;
  return scale;
}

std::vector<LegendEntry> legend(std::size_t joints) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < joints; ++i) {
    entries.push_back({fmt::format("joint {}", i + 1), {.color = kJointColors[i], .width = 2}, 76});
  }
  entries.push_back({"set-point", {.color = "#57606a", .width = 2}, 96});
  entries.push_back({"encoder", {.color = "#57606a", .width = 1.2, .dashes = "3 2"}, 96});
  return entries;
}

}  // namespace

std::string joints_figure(const RunRecord& run) {
  constexpr double kAngleHeight = 270;
  constexpr double kSpeedHeight = 220;
  constexpr double kGap = 22;
  const std::size_t count = std::min(run.axis_count(), kJointColors.size());
  std::vector<JointCurves> joints;
  for (std::size_t i = 0; i < count; ++i) joints.push_back(curves_of(run.trace, i));

  const std::string title = run.summary["description"].get<std::string>();
  const Caption caption{title,
                        fmt::format("{}: angle and speed of each joint", run.summary["scenario"].get<std::string>())};
  const double legend_y = caption.height() + 28;
  const PlotPoint upper{kPictureLeft, legend_y + 14};
  const PlotPoint lower{kPictureLeft, upper.y + kAngleHeight + kGap};
  SvgPicture picture{kPictureWidth, lower.y + kSpeedHeight + 50, title};
  caption.draw(picture);
  draw_legend(picture, legend_y, legend(count));

  const std::vector<PlotPoint>& times = joints.front().reference;
  const AxisScale time = time_scale(times.back().x);
  const double width = kPictureRight - kPictureLeft;
  const auto angle_scale = scale_of(joints, [](const JointCurves& joint) { return joint.reference; });
  Panel angles{picture,
               {.corner = upper,
                .width = width,
                .height = kAngleHeight,
                .x = time,
                .y = angle_scale,
                .x_label = {},
                .y_label = "angle [deg]"}};
  const auto speed_scale = scale_of(joints, [](const JointCurves& joint) { return joint.speed; });
  Panel speeds{picture,
               {.corner = lower,
                .width = width,
                .height = kSpeedHeight,
                .x = time,
                .y = speed_scale,
                .x_label = "time [s]",
                .y_label = "speed [deg/s]"}};
  for (std::size_t i = 0; i < count; ++i) {
    angles.curve(joints[i].reference, {.color = kJointColors[i], .width = 2});
    angles.curve(joints[i].encoder, {.color = kJointColors[i], .width = 1.2, .dashes = "3 2"});
    speeds.curve(joints[i].speed, {.color = kJointColors[i], .width = 2});
  }
  return picture.document();
}

}  // namespace armature::cosim
