#include "cosim/snapshot/point_pacing.hpp"

#include <algorithm>

namespace armature::cosim {
namespace {

constexpr int kTimesOfAPoint = 20;  // where a point takes long the next one is so many times later

}  // namespace

bool PointPacing::is_due(Duration worked, std::size_t points, std::optional<std::int64_t> gap) const {
  if (points >= most_) return false;
  const Duration since_point = worked - worked_at_point_;
  const bool half_way = gap && *gap >= rules_.finest && *gap <= gap_at_point_ / 2;
  if (half_way && since_point >= takes_) return true;
  return points < rules_.most &&
         since_point >= std::max({rules_.between, worked / rules_.part_of_the_run, takes_ * kTimesOfAPoint});
}

}  // namespace armature::cosim
