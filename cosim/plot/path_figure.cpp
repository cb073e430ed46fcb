#include "cosim/plot/path_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/plot/caption.hpp"
#include "cosim/plot/drawing_plane.hpp"
#include "cosim/plot/panel.hpp"
#include "cosim/plot/path_rows.hpp"
#include "cosim/plot/planned_path.hpp"
#include "cosim/plot/svg.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/json.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr Pen kPlanned{.color = "#8c959f", .width = 1.2, .dashes = "6 4"};
constexpr Pen kSetPoints{.color = "#9ecbff", .width = 5};
constexpr Pen kEncoders{.color = "#0550ae", .width = 1.5};
constexpr Pen kRapids{.color = "#0550ae", .width = 0.8, .dashes = "3 4"};

// The tool centre point of `side`, "ref" or "enc".
class ToolColumnsOf {
 public:
  ToolColumnsOf(const TraceTable& trace, std::string_view side) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string name = fmt::format("tcp_{}_{}_mm", side, "xyz"[i]);
      columns_[i] = trace.find(name);
      if (columns_[i] == nullptr) {
        throw InputError{trace.file, "has no column '" + name + "'; run the scenario with --set trace.tcp=true"};
      }
    }
  }
  [[nodiscard]] SpacePoints points(const PathRows& rows) const {
    SpacePoints points;
    for (std::size_t row = rows.first; row <= rows.last; ++row) {
      points.emplace_back(columns_[0]->number(row), columns_[1]->number(row), columns_[2]->number(row));
    }
    return points;
  }

 private:
  std::array<const NumberColumn*, 3> columns_{};
};

struct DrawnPath {
  std::vector<SpacePoints> planned, set_points, encoders;  // pieces
  std::vector<SpacePoints> rapids;                         // of the encoders
  SpacePoints all;
};

DrawnPath drawn_path(const RunRecord& run) {
  const ToolColumnsOf reference{run.trace, "ref"};
  const ToolColumnsOf encoder{run.trace, "enc"};
  DrawnPath path;
  for (const Json& move : run.summary["result"]["moves"]) {
    if (!move.value("rapid", false)) path.planned.push_back(planned_path(move));
  }
  std::erase_if(path.planned, [](const SpacePoints& points) { return points.empty(); });
  for (const PathRows& rows : path_rows(run)) {
    (rows.rapid ? path.rapids : path.encoders).push_back(encoder.points(rows));
    if (!rows.rapid) path.set_points.push_back(reference.points(rows));
  }
  for (const auto* pieces : {&path.planned, &path.set_points, &path.encoders, &path.rapids}) {
    for (const SpacePoints& piece : *pieces) std::ranges::copy(piece, std::back_inserter(path.all));
  }
  if (path.all.empty() || !std::ranges::all_of(path.all, [](const auto& point) { return point.allFinite(); })) {
    throw InputError{run.trace.file, "has no position of the tool; the robot needs [kinematics]"};
  }
  return path;
}

// The ways between cuts have no part in it.
DrawingPlane plane_of(const RunRecord& run, const DrawnPath& path) {
  SpacePoints cuts;
  for (const auto* pieces : {&path.planned, &path.set_points, &path.encoders}) {
    for (const SpacePoints& piece : *pieces) std::ranges::copy(piece, std::back_inserter(cuts));
  }
  return plane_of_run(run, cuts.empty() ? path.all : cuts);
}

std::string plane_text(const DrawingPlane& plane) {
  if (!plane.frame.empty()) return fmt::format("path of the tool, seen along z of {}", plane.frame);
  return plane.tilt_deg < 0.5
             ? "path of the tool in its plane, which is level"
             : fmt::format("path of the tool in its plane, which is tilted by {} deg", fixed_text(plane.tilt_deg, 0));
}

// "0.46 mm", or "not measured".
std::string off_by_text(const RunRecord& run, const char* key) {
  const Json& result = run.summary["result"];
  if (!result.contains(key) || !result[key].is_object()) return "not measured";
  return fixed_text(result[key]["mm"].get<double>(), 3) + " mm";
}

std::vector<LegendEntry> legend_of(const RunRecord& run, const DrawnPath& path) {
  const bool rapids = !path.rapids.empty();
  const double width = rapids ? 243 : 275;
  std::vector<LegendEntry> entries{
      {"programmed", kPlanned, 110},
      {"set-points, off by at most " + off_by_text(run, "command_path_error"), kSetPoints, width},
      {"encoders, off by at most " + off_by_text(run, "path_error"), kEncoders, width}};
  if (rapids) entries.push_back({"rapids", kRapids, 60});
  return entries;
}

// Scales of the same length for a millimetre in both directions. `height` is that of the frame.
struct SquareScales {
  AxisScale x, y;
  double height = 0;
};

SquareScales square_scales(const std::vector<PlotPoint>& points, double width) {
  constexpr double kMargin = 1.08;
  constexpr double kMaxHeight = 1.0;  // of the width
  constexpr double kLeastHeight = 0.4;
  const auto [left, right] = std::ranges::minmax_element(points, {}, &PlotPoint::x);
  const auto [bottom, top] = std::ranges::minmax_element(points, {}, &PlotPoint::y);
  constexpr double kLeastMm = 0.1;
  const double across = std::max(right->x - left->x, kLeastMm) * kMargin;
  const double upwards = std::max(top->y - bottom->y, kLeastMm) * kMargin;
  const double height = std::clamp(upwards / across, kLeastHeight, kMaxHeight) * width;
  const double mm_px = std::max(across / width, upwards / height);
  const double x = (left->x + right->x) / 2;
  const double y = (bottom->y + top->y) / 2;
  constexpr int kSteps = 12;
  return {.x = exact_scale(x - mm_px * width / 2, x + mm_px * width / 2, kSteps),
          .y = exact_scale(y - mm_px * height / 2, y + mm_px * height / 2, kSteps),
          .height = height};
}

}  // namespace

std::string path_figure(const RunRecord& run) {
  const DrawnPath path = drawn_path(run);
  const DrawingPlane plane = plane_of(run, path);
  const auto flat = [&](const SpacePoints& points) {
    std::vector<PlotPoint> drawn;
    std::ranges::transform(points, std::back_inserter(drawn), [&](const auto& point) { return plane.of(point); });
    return drawn;
  };
  const std::string title = run.summary["description"].get<std::string>();
  const Caption caption{title, fmt::format("{}: {}", run.summary["scenario"].get<std::string>(), plane_text(plane))};
  const double width = kPictureRight - kPictureLeft;
  const SquareScales scales = square_scales(flat(path.all), width);
  const double legend_y = caption.height() + 28;
  const PlotPoint corner{kPictureLeft, legend_y + 14};
  SvgPicture picture{kPictureWidth, corner.y + scales.height + 50, title};
  caption.draw(picture);
  draw_legend(picture, legend_y, legend_of(run, path));
  Panel panel{picture,
              {.corner = corner,
               .width = width,
               .height = scales.height,
               .x = scales.x,
               .y = scales.y,
               .x_label = plane.right.label,
               .y_label = plane.up.label}};
  for (const SpacePoints& piece : path.set_points) panel.curve(flat(piece), kSetPoints);
  for (const SpacePoints& piece : path.planned) panel.curve(flat(piece), kPlanned);
  for (const SpacePoints& piece : path.rapids) panel.curve(flat(piece), kRapids);
  for (const SpacePoints& piece : path.encoders) panel.curve(flat(piece), kEncoders);
  const auto& begin = path.encoders.empty() ? path.rapids : path.encoders;
  panel.dot(plane.of(begin.front().front()), 5, kEncoders.color);
  return picture.document();
}

}  // namespace armature::cosim
