// The fastest motion along a path: the speed at every point of a grid, as large as the limits there and the braking
// before all later points permit. Time-optimal path parameterisation by reachability analysis, see Pham and Pham,
// "A New Approach to Time-Optimal Path Parameterization Based on Reachability Analysis", IEEE T-RO 2018.
//
//   backward pass  at each grid point the largest x = v^2 from which the rest of the path can be executed
//   forward pass   from the start, in each interval the largest acceleration that stays below these
//
// Between grid points the acceleration is constant, so the motion is a sequence of parabolas (time_table.hpp). Where
// the law changes from accelerating to cruising or braking within an interval, a grid point is added there and the
// passes are repeated. A law with constant limits is then exact: a trapezoid or a triangle.
//
// A break of the path's second derivative is two grid points at the same place. The motion stops at points that say so
// and at the last one, so the law is safe if nothing follows. A law can be continued while it runs: drop_front()
// removes what has been executed, append() adds points behind, and the passes begin again with the speed that the law
// has at its first point. Memory is fixed, a ring.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "controller/trajectory/law/law_limits.hpp"

namespace armature {

class SpeedLaw {
 public:
  static constexpr std::size_t kMaxPoints = 4096;
  static constexpr int kMaxRounds = 5;
  enum class Progress : std::uint8_t { kWorking, kDone };

  // Removes all points. The motion then starts at rest. At most `most` <= kMaxPoints points are used.
  void clear(std::size_t most = kMaxPoints) noexcept;
  [[nodiscard]] std::size_t most() const noexcept { return most_; }
  // Uses at most `most` <= kMaxPoints points from now on, no fewer than there are.
  void use(std::size_t most) noexcept { most_ = most; }
  // Adds a grid point at `s`, not before the last one. `limits.most_square` must be finite and above 0. `stops`: the
  // motion stops here. False: no room.
  bool append(double s, const LawLimits& limits, bool stops = false) noexcept;
  // Removes the first `count` < size() points. The law starts at the next one with the speed that it has there.
  void drop_front(std::size_t count) noexcept;
  // Adds a point at `s` within an interval of a law whose passes are done, if there is room and no other point is
  // close.
  void split(double s) noexcept;
  // Removes all points behind `s`, and those at `s` where the motion stops.
  void drop_behind(double s) noexcept;
  // The law starts with this square of the speed, if the limits permit it: after drop_front(), from the next begin()
  // on.
  void start_with(double square) noexcept { start_square_ = square; }
  [[nodiscard]] double start_square() const noexcept { return start_square_; }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] double s(std::size_t point) const noexcept { return at(point).s; }
  [[nodiscard]] bool stops(std::size_t point) const noexcept { return point + 1 == size_ || at(point).stops; }
  // The last point at or before `s`, 0 before the first.
  [[nodiscard]] std::size_t point_at(double s) const noexcept;
  // To be changed only before begin().
  [[nodiscard]] LawLimits& limits(std::size_t point) noexcept { return at(point).limits; }
  [[nodiscard]] const LawLimits& limits(std::size_t point) const noexcept { return at(point).limits; }

  // Slows the law down between two places by `share`, 0..1, from the next begin() on. Where several demands meet, the
  // smallest share applies. In a long interval points are added, so that no more of the path than about three times
  // this part becomes slower.
  void lower(double from, double to, double share) noexcept;

  // Limits x to `square` between two places, from the next begin() on, until free() removes the limits of all cap()s
  // and the points that were added.
  void cap(double from, double to, double square) noexcept;
  void free() noexcept;
  // Removes the limits only.
  void uncap() noexcept;
  // For a law that does not start as asked: raises the limits of cap() to what can be reached from the start, from the
  // next begin() on. If they permit that, it takes back half of what lower() demands on the way on which the law must
  // brake. False: nothing is left to take back.
  [[nodiscard]] bool ease_start() noexcept;

  // Starts the passes over the present points, at least two. Points are added in at most `rounds` - 1 rounds: constant
  // limits need three for a trapezoid that is one interval.
  void begin(int rounds = kMaxRounds) noexcept;
  // Continues them for about this many intervals. One takes some microseconds.
  Progress work(std::size_t intervals) noexcept;
  void plan() noexcept {
    begin();
    while (work(size_) == Progress::kWorking) {
    }
  }

  // False: the limits do not permit the speed at the start, and the law starts more slowly. Valid when the passes are
  // done.
  [[nodiscard]] bool starts_as_asked() const noexcept { return start_square_ <= at(0).square * (1.0 + kSameStart); }

  // The square of the speed at a point. Valid when the passes are done.
  [[nodiscard]] double square(std::size_t point) const noexcept { return at(point).square; }
  // Of the interval after a point, whose length is above 0.
  [[nodiscard]] double duration_s(std::size_t point) const noexcept;
  [[nodiscard]] double accel(std::size_t point) const noexcept;

 private:
  static constexpr double kSameStart = 1e-7;  // share
  struct Point {
    double s = 0.0;
    LawLimits limits{};
    double cap = std::numeric_limits<double>::infinity();
    bool stops = false;
    bool added = false;
    bool brakes = false;     // the rest of the path determines `most`, not the limits at this point
    double most = 0.0;       // largest x from which the rest can be executed, also at a stop
    double square = 0.0;     // x of the law
    double share = 1.0;      // by which lower() slows down, from the next begin() on
    double slowed = 1.0;     // by which the limits are slowed down, since drop_front()
    double add_after = 0.0;  // a point is to be added at this distance behind; 0: none
  };
  enum class Pass : std::uint8_t { kBackward, kForward, kAdd, kDone };

  [[nodiscard]] Point& at(std::size_t point) noexcept { return points_[(first_ + point) % kMaxPoints]; }
  [[nodiscard]] const Point& at(std::size_t point) const noexcept { return points_[(first_ + point) % kMaxPoints]; }
  // Largest x with which the law may arrive at a point.
  [[nodiscard]] double most_at(std::size_t point) const noexcept { return stops(point) ? 0.0 : at(point).most; }
  void pass_back(std::size_t point) noexcept;
  void pass_forth(std::size_t point) noexcept;
  void add_points() noexcept;
  void add_near(double s, double nearest) noexcept;
  [[nodiscard]] static Point between(const Point& first, const Point& second, double s) noexcept;
  // The limits of a point, and cap().
  [[nodiscard]] static LawLimits capped(const Point& point) noexcept;

  std::array<Point, kMaxPoints> points_{};
  std::size_t first_ = 0, size_ = 0, most_ = kMaxPoints;
  double start_square_ = 0.0;
  Pass pass_ = Pass::kDone;
  std::size_t next_ = 0;  // the interval that follows in the pass
  std::size_t to_add_ = 0;
  int rounds_ = 0;  // left
};

}  // namespace armature
