#include "cosim/plot/path_rows.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

struct PathTicks {
  std::int64_t first = 0, last = 0;
  bool rapid = false;
};

std::vector<PathTicks> path_ticks(const RunRecord& run) {
  std::vector<PathTicks> paths;
  for (const Json& move : run.summary["result"]["moves"]) {
    if (!move.contains("path")) continue;
    const auto start = move["start_tick"].get<std::int64_t>();
    const Json& duration = move["taken_ticks"].is_null() ? move["duration_ticks"] : move["taken_ticks"];
    paths.push_back({start, start + duration.get<std::int64_t>(), move.value("rapid", false)});
  }
  std::ranges::stable_sort(paths, {}, &PathTicks::first);
  return paths;
}

// The path that is under way in each tick; in a rounded corner the later one. To be asked in the order of time.
class PathUnderWay {
 public:
  explicit PathUnderWay(std::vector<PathTicks> paths) : paths_{std::move(paths)} {}
  [[nodiscard]] const PathTicks* at(std::int64_t tick) {
    while (next_ < paths_.size() && paths_[next_].first <= tick) ++next_;
    return next_ > 0 && tick <= paths_[next_ - 1].last ? &paths_[next_ - 1] : nullptr;
  }

 private:
  std::vector<PathTicks> paths_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<PathRows> path_rows(const RunRecord& run) {
  std::vector<PathTicks> paths = path_ticks(run);
  if (paths.empty()) return {{.first = 0, .last = run.trace.rows() - 1}};
  const NumberColumn& tick = run.trace.column("tick");
  PathUnderWay under_way{std::move(paths)};
  std::vector<PathRows> pieces;
  bool inside = false;
  for (std::size_t row = 0; row < run.trace.rows(); ++row) {
    const PathTicks* path = under_way.at(tick.values[row]);
    if (path != nullptr && (!inside || pieces.back().rapid != path->rapid)) {
      pieces.push_back({.first = inside ? row - 1 : row, .last = row, .rapid = path->rapid});
    }
    if (path != nullptr) pieces.back().last = row;
    inside = path != nullptr;
  }
  return pieces;
}

}  // namespace armature::cosim
