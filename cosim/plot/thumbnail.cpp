#include "cosim/plot/thumbnail.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

#include "controller/base/axes.hpp"
#include "cosim/plot/drawing_plane.hpp"
#include "cosim/plot/joint_colors.hpp"
#include "cosim/plot/path_rows.hpp"
#include "cosim/plot/simplify.hpp"
#include "cosim/plot/svg.hpp"
#include "cosim/recording/recorded_arm.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

constexpr double kThumbnailWidth = 150, kThumbnailHeight = 84, kThumbnailMargin = 7;
constexpr double kUnseenPx = 0.2;
constexpr Pen kThinCut{.color = "#0550ae", .width = 1.2};
constexpr Pen kThinRapid{.color = "#8c959f", .width = 0.7, .dashes = "2 2"};

struct ThumbnailCurve {
  std::vector<PlotPoint> points;
  Pen pen;
};

// `square`: a unit is as long in both directions.
std::string drawn(std::vector<ThumbnailCurve> curves, std::string_view title, bool square) {
  constexpr double kLeast = 1e-6;
  PlotPoint low = curves.front().points.front();
  PlotPoint high = low;
  for (const ThumbnailCurve& curve : curves) {
    for (const PlotPoint point : curve.points) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
  }
  double across = (kThumbnailWidth - 2 * kThumbnailMargin) / std::max(high.x - low.x, kLeast);
  double upwards = (kThumbnailHeight - 2 * kThumbnailMargin) / std::max(high.y - low.y, kLeast);
  if (square) across = upwards = std::min(across, upwards);
  const PlotPoint middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  SvgPicture picture{kThumbnailWidth, kThumbnailHeight, title};
  for (ThumbnailCurve& curve : curves) {
    for (PlotPoint& point : curve.points) {
      point = {kThumbnailWidth / 2 + (point.x - middle.x) * across,
               kThumbnailHeight / 2 - (point.y - middle.y) * upwards};
    }
    picture.polyline(simplify(curve.points, kUnseenPx), curve.pen);
  }
  return picture.document();
}

SpacePoints tool_points(const RunRecord& run, const RecordedArm& arm, const PathRows& rows) {
  const std::vector<const NumberColumn*> columns = run.axis_columns("enc_deg");
  SpacePoints points;
  for (std::size_t row = rows.first; row <= rows.last; ++row) {
    PerAxis<double> angles{};
    for (std::size_t i = 0; i < columns.size(); ++i) angles[i] = columns[i]->number(row);
    points.push_back(arm.tool(angles).translation());
  }
  return points;
}

std::string path_thumbnail(const RunRecord& run, const RecordedArm& arm) {
  std::vector<std::pair<SpacePoints, bool>> pieces;  // and whether it is a rapid
  SpacePoints cuts, all;
  for (const PathRows& rows : path_rows(run)) {
    pieces.emplace_back(tool_points(run, arm, rows), rows.rapid);
    std::ranges::copy(pieces.back().first, std::back_inserter(all));
    if (!rows.rapid) std::ranges::copy(pieces.back().first, std::back_inserter(cuts));
  }
  const DrawingPlane plane = plane_of_run(run, cuts.empty() ? all : cuts);
  std::vector<ThumbnailCurve> curves;
  for (const auto& [points, rapid] : pieces) {
    ThumbnailCurve& curve = curves.emplace_back(ThumbnailCurve{{}, rapid ? kThinRapid : kThinCut});
    for (const Eigen::Vector3d& point : points) curve.points.push_back(plane.of(point));
  }
  return drawn(std::move(curves), "path of the tool", true);
}

std::string joints_thumbnail(const RunRecord& run) {
  const NumberColumn& time = run.trace.column("time_s");
  const std::vector<const NumberColumn*> columns = run.axis_columns("enc_deg");
  std::vector<ThumbnailCurve> curves;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    ThumbnailCurve& curve = curves.emplace_back(ThumbnailCurve{{}, {.color = kJointColors[i % kJointColors.size()]}});
    for (std::size_t row = 0; row < run.trace.rows(); ++row) {
      curve.points.push_back({time.number(row), columns[i]->number(row)});
    }
  }
  return drawn(std::move(curves), "angles of the joints", false);
}

}  // namespace

std::string thumbnail(const RunRecord& run) {
  const auto& moves = run.summary["result"]["moves"];
  const bool has_path = std::ranges::any_of(moves, [](const Json& move) { return move.contains("path"); });
  const std::optional<RecordedArm> arm = RecordedArm::of(run.summary);
  return has_path && arm && !path_rows(run).empty() ? path_thumbnail(run, *arm) : joints_thumbnail(run);
}

}  // namespace armature::cosim
