// Decides when a process takes another point to which it can return (return_points.hpp): by the host time for which it
// has worked, so that points cost a small part of it.
//
// On the way to a position behind which the process was there are more: at half of the way, at half of the rest, and so
// on. Who goes back often does so again, by little.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace armature::cosim {

class PointPacing {
 public:
  using Duration = std::chrono::steady_clock::duration;
  struct Rules {
    Duration between{};       // two points are at least so far apart,
    int part_of_the_run = 1;  // and by this part of all the time for which the process has worked
    std::size_t most = 0;     // points
    std::size_t more = 0;     // that only a way back may take
    std::int64_t finest = 0;  // no point of a way back is nearer to its end; in units of the position
  };
  explicit PointPacing(const Rules& rules) : rules_{rules}, most_{rules.most + rules.more} {}

  // Whether a point is due. `worked`: the host time for which the process has worked. `points`: that exist. `gap`: the
  // rest of the way to the position to which the process was taken back; none: it was not.
  [[nodiscard]] bool is_due(Duration worked, std::size_t points, std::optional<std::int64_t> gap) const;

  // A way of this length begins.
  void begin_way(std::int64_t gap) { gap_at_point_ = gap; }
  // A point is about to be taken. What is_due() has decided by is then part of it.
  void begin_point(Duration worked, std::int64_t gap) {
    worked_at_point_ = worked;
    gap_at_point_ = gap;
  }
  // The point was taken, which took so long.
  void end_point(Duration takes) { takes_ = takes; }
  // The host has refused one beside these: there will be no more. The way back is longer then.
  void refused(std::size_t points) { most_ = points; }

 private:
  Rules rules_;
  std::size_t most_;
  Duration worked_at_point_{}, takes_{};
  std::int64_t gap_at_point_ = 0;
};

}  // namespace armature::cosim
