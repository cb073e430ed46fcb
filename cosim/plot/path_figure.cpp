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

// Rows of the trace, from the first one to the last one.
using RowSpan = std::pair<std::size_t, std::size_t>;

// The rows in which moves on paths are under way, in connected pieces. Without such a move: all rows.
std::vector<RowSpan> path_rows(const RunRecord& run) {
  std::vector<std::pair<std::int64_t, std::int64_t>> ticks;
  for (const Json& move : run.summary["result"]["moves"]) {
    if (!move.contains("path")) continue;
    const auto start = move["start_tick"].get<std::int64_t>();
    const Json& duration = move["taken_ticks"].is_null() ? move["duration_ticks"] : move["taken_ticks"];
    ticks.emplace_back(start, start + duration.get<std::int64_t>());
  }
  const NumberColumn& tick = run.trace.column("tick");
  const auto on_path = [&](std::size_t row) {
    return ticks.empty() || std::ranges::any_of(ticks, [now = tick.values[row]](const auto& span) {
             return now >= span.first && now <= span.second;
           });
  };
  std::vector<RowSpan> spans;
  bool inside = false;
  for (std::size_t row = 0; row < run.trace.rows(); ++row) {
    const bool now = on_path(row);
    if (now && !inside) spans.emplace_back(row, row);
    if (now) spans.back().second = row;
    inside = now;
  }
  return spans;
}

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
  [[nodiscard]] SpacePoints points(RowSpan rows) const {
    SpacePoints points;
    for (std::size_t row = rows.first; row <= rows.second; ++row) {
      points.emplace_back(columns_[0]->number(row), columns_[1]->number(row), columns_[2]->number(row));
    }
    return points;
  }

 private:
  std::array<const NumberColumn*, 3> columns_{};
};

struct DrawnPath {
  std::vector<SpacePoints> planned, set_points, encoders;  // pieces
  SpacePoints all;
};

DrawnPath drawn_path(const RunRecord& run) {
  const ToolColumnsOf reference{run.trace, "ref"};
  const ToolColumnsOf encoder{run.trace, "enc"};
  DrawnPath path;
  for (const Json& move : run.summary["result"]["moves"]) path.planned.push_back(planned_path(move));
  std::erase_if(path.planned, [](const SpacePoints& points) { return points.empty(); });
  for (const RowSpan& rows : path_rows(run)) {
    path.set_points.push_back(reference.points(rows));
    path.encoders.push_back(encoder.points(rows));
  }
  for (const auto* pieces : {&path.planned, &path.set_points, &path.encoders}) {
    for (const SpacePoints& piece : *pieces) std::ranges::copy(piece, std::back_inserter(path.all));
  }
  if (path.all.empty() || !std::ranges::all_of(path.all, [](const auto& point) { return point.allFinite(); })) {
    throw InputError{run.trace.file, "has no position of the tool; the robot needs [kinematics]"};
  }
  return path;
}

// "0.46 mm", or "not measured".
std::string off_by_text(const RunRecord& run, const char* key) {
  const Json& result = run.summary["result"];
  if (!result.contains(key) || !result[key].is_object()) return "not measured";
  return fixed_text(result[key]["mm"].get<double>(), 3) + " mm";
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
  const DrawingPlane plane = drawing_plane(path.all);
  const auto flat = [&](const SpacePoints& points) {
    std::vector<PlotPoint> drawn;
    std::ranges::transform(points, std::back_inserter(drawn), [&](const auto& point) { return plane.of(point); });
    return drawn;
  };
  const std::string title = run.summary["description"].get<std::string>();
  const Caption caption{
      title,
      fmt::format("{}: path of the tool in its plane, {}", run.summary["scenario"].get<std::string>(),
                  plane.tilt_deg < 0.5 ? "which is level"
                                       : fmt::format("which is tilted by {} deg", fixed_text(plane.tilt_deg, 0)))};
  const double width = kPictureRight - kPictureLeft;
  const SquareScales scales = square_scales(flat(path.all), width);
  const double legend_y = caption.height() + 28;
  const PlotPoint corner{kPictureLeft, legend_y + 14};
  SvgPicture picture{kPictureWidth, corner.y + scales.height + 50, title};
  caption.draw(picture);
  draw_legend(picture, legend_y,
              {{"programmed", kPlanned, 110},
               {"set-points, off by at most " + off_by_text(run, "command_path_error"), kSetPoints, 275},
               {"encoders, off by at most " + off_by_text(run, "path_error"), kEncoders, 275}});
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
  for (const SpacePoints& piece : path.encoders) panel.curve(flat(piece), kEncoders);
  panel.dot(plane.of(path.encoders.front().front()), 5, kEncoders.color);
  return picture.document();
}

}  // namespace armature::cosim
