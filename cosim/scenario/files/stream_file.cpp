#include "cosim/scenario/files/stream_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "cosim/poses/number_csv.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

CsvLayout stream_joint_columns(std::size_t joints) {
  CsvLayout layout{{"time_s", kMaxDurationS, "s"}};
  for (std::size_t i = 0; i < joints; ++i) layout.push_back({fmt::format("j{}_deg", i + 1), kMaxAngleDeg, "deg"});
  return layout;
}

CsvLayout stream_tool_columns() {
  return {{"time_s", kMaxDurationS, "s"},  {"x_mm", kMaxPlaceMm, "mm"},       {"y_mm", kMaxPlaceMm, "mm"},
          {"z_mm", kMaxPlaceMm, "mm"},     {"roll_deg", kMaxAngleDeg, "deg"}, {"pitch_deg", kMaxAngleDeg, "deg"},
          {"yaw_deg", kMaxAngleDeg, "deg"}};
}

}  // namespace

double StreamSpec::delay_s() const {
  if (delay_ms) return *delay_ms * 1e-3;
  std::int64_t longest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) longest = std::max(longest, points[i].ticks - points[i - 1].ticks);
  return 2.5 * static_cast<double>(longest) * kTickSeconds;
}

void parse_stream(std::string_view text, const std::string& name, std::size_t joints, StreamSpec& stream) {
  const std::array layouts{stream_joint_columns(joints), stream_tool_columns()};
  const std::int64_t shortest = std::llround(kShortestInterval_s / kTickSeconds);
  stream.points.clear();
  const std::size_t layout = read_number_csv(text, name, layouts, [&](const NumberRow& row, CsvProblems& problems) {
    StreamSpec::Point point{.ticks = std::llround(row.values[0] / kTickSeconds)};
    std::copy(row.values.begin() + 1, row.values.end(), point.values.begin());
    const bool first = stream.points.empty();
    if (first && point.ticks != 0) {
      problems.add(row.line, row.columns[0], "time_s",
                   "expected 0 in the first row, found " + number_text(row.values[0]));
    } else if (!first && point.ticks < stream.points.back().ticks + shortest) {
      problems.add(row.line, row.columns[0], "time_s",
                   fmt::format("expected at least {} (s) more than in the row before, found {}",
                               number_text(kShortestInterval_s), number_text(row.values[0])));
    }
    stream.points.push_back(point);
  });
  if (stream.points.size() < 2) {
    throw InputError{name, fmt::format("expected at least two set-points, found {}", stream.points.size())};
  }
  stream.kind = layout == 0 ? StreamSpec::Kind::kJoints : StreamSpec::Kind::kTool;
}

}  // namespace armature::cosim
