#include "tests/controller/support/jerk_oracle.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/cartesian/path_corners.hpp"
#include "tests/controller/support/jerk_oracle_law.hpp"
#include "tests/controller/support/jerk_oracle_path.hpp"
#include "tests/controller/support/jerk_oracle_solver.hpp"

namespace armature::test {
namespace {

using jerk_oracle::Constraint;
using jerk_oracle::kNone;
using jerk_oracle::Knot;
using jerk_oracle::kQuantities;
using jerk_oracle::Law;
using jerk_oracle::Limit;
using jerk_oracle::of;
using jerk_oracle::Path;
using jerk_oracle::place;
using jerk_oracle::Pose;
using jerk_oracle::Samples;
using jerk_oracle::Solver;
using jerk_oracle::Vector;

// A run of the path, from stop to stop.
class Run {
 public:
  Run(const PathRig& rig, const CartesianSegment& segment, double from, double to, const JointAngles& start)
      : path_{rig, segment}, planned_{rig.planner.plan().table}, from_{from}, to_{to}, start_{start} {}

  OracleMotion solve(int nodes) {
    OracleMotion result;
    Law law = first_law(std::min(nodes, 500));
    for (int size = 500;; size = std::min(nodes, 3 * size)) {
      look_at_path(law);
      for (int round = 0; round < 3; ++round) {
        solver_.minimise(law, constraints(law));
        if (law.set_lengths() < 1e-4) break;
      }
      if (size >= nodes) break;
      law = regrid(law, std::min(nodes, 3 * size));
    }
    for (int round = 0; round < 10; ++round) {
      for (int k = 0; k < 3; ++k) {
        solver_.minimise(law, constraints(law));
        if (law.set_lengths() < 1e-6) break;
        law.update();
      }
      const std::vector<Knot> motion = law.motion();
      result.duration_s = motion.back().t;
      if (check(law, motion, result.shares)) break;
    }
    return result;
  }

  [[nodiscard]] const JointAngles& end() const { return joints_at_end_; }

 private:
  static constexpr double kClosest = 1e-11;  // points, as a share of the length

  // Its points are where the planned motion is at equally spaced times.
  [[nodiscard]] Law first_law(int size) const {
    const double begin_s = planned_.time_at(from_), took_s = planned_.time_at(to_) - begin_s;
    std::vector<double> s{from_};
    for (int i = 1; i < size; ++i) {
      const double at = planned_.position(begin_s + took_s * i / size), least = kClosest * (to_ - from_);
      if (at - s.back() > least && to_ - at > least) s.push_back(at);
    }
    s.push_back(to_);
    Law law{s};
    for (std::size_t k = 0; k < law.intervals(); ++k) {
      law.x(k) = std::pow(planned_.passing(0.5 * (s[k] + s[k + 1])).speed, 2);
    }
    for (int round = 0; round < 20; ++round) {  // without the noise of the planned law
      for (std::size_t k = 1; k + 1 < law.intervals(); ++k) {
        law.x(k) = 0.5 * law.x(k) + 0.25 * (law.x(k - 1) + law.x(k + 1));
      }
    }
    return law;
  }

  // Equally spaced in the time of a law.
  [[nodiscard]] static Law regrid(const Law& law, int size) {
    const std::vector<Knot> motion = law.motion();
    const double from = law.nodes().front(), to = law.nodes().back();
    std::vector<double> s{from};
    std::size_t at = 0;
    for (int i = 1; i < size; ++i) {
      const double next = place(motion, motion.back().t * i / size, at);
      if (next - s.back() > kClosest * (to - from) && to - next > kClosest * (to - from)) s.push_back(next);
    }
    s.push_back(to);
    Law finer{s};
    std::size_t node = 0;
    for (std::size_t k = 0; k < finer.intervals(); ++k) {
      const double middle = 0.5 * (s[k] + s[k + 1]);
      while (node + 2 < law.nodes().size() && law.s(node + 1) <= middle) ++node;
      const double share = (middle - law.s(node)) / (law.s(node + 1) - law.s(node));
      finer.x(k) = (1.0 - share) * law.b(node) + share * law.b(node + 1);
    }
    return finer;
  }

  void look_at_path(const Law& law) {
    const std::size_t n = law.intervals();
    slope_.assign(n + 1, {});
    bend_.assign(n + 1, {});
    most_.assign(n + 1, kNone);
    Pose last = path_.first(law.s(0), start_);
    for (std::size_t i = 1; i < n; ++i) {
      const double delta = 0.5 * std::min(law.s(i) - law.s(i - 1), law.s(i + 1) - law.s(i));
      const Pose a = path_.next(law.s(i) - delta, last), here = path_.next(law.s(i), a),
                 b = path_.next(law.s(i) + delta, here);
      for (std::size_t q = 0; q < kQuantities; ++q) {
        slope_[i][q] = (of(b, q) - of(a, q)) / (2.0 * delta);
        bend_[i][q] = (of(b, q) - 2.0 * of(here, q) + of(a, q)) / (delta * delta);
        const double slope = slope_[i][q].norm();
        if (slope > 0.0) most_[i] = std::min(most_[i], std::pow(path_.limit(q).speed / slope, 2));
      }
      last = b;
    }
    joints_at_end_ = path_.next(law.s(n), last).joints;
    accel_share_.assign(n + 1, 1.0);
    jerk_share_.assign(n + 1, 1.0);
  }

  // The limits, as the unknowns of the law see them.
  [[nodiscard]] std::vector<Constraint> constraints(const Law& law) const {
    std::vector<Constraint> result;
    const auto add = [&](const Constraint& c) {
      double size = 0.0;
      for (const Vector& part : c.part) size += part.norm();
      if (size > 0.0) result.push_back(c);
    };
    const std::size_t n = law.intervals();
    // Of the acceleration at a node, by the unknowns from node - 2 on.
    const auto accel = [&](std::size_t i, std::size_t q) {
      std::array<Vector, 4> result;
      const Law::Node by = law.node(i);
      for (std::size_t m = 0; m < 4; ++m) result[m] = slope_[i][q] * by.a[m] + bend_[i][q] * by.b[m];
      return result;
    };
    for (std::size_t q = 0; q < kQuantities; ++q) {
      const Limit& limit = path_.limit(q);
      if (limit.accel == kNone) continue;
      for (std::size_t i = 1; i < n; ++i) {
        Constraint c{.first = i - 2, .part = accel(i, q)};
        for (Vector& part : c.part) part /= limit.accel * accel_share_[i];
        add(c);
      }
      for (std::size_t k = 0; k < n; ++k) {
        Constraint c{.first = k - 1, .interval = k};
        c.part.fill(Vector::Zero());
        const double most = limit.jerk * std::min(jerk_share_[k], jerk_share_[k + 1]);
        if (k > 0) {
          const auto before = accel(k, q);  // its first unknown is a fixed one, or none
          for (std::size_t m = 1; m < 4; ++m) c.part[m - 1] -= before[m] / most;
        }
        if (k + 1 < n) {
          const auto after = accel(k + 1, q);
          for (std::size_t m = 0; m < 4; ++m) c.part[m] += after[m] / most;
        }
        add(c);
      }
    }
    for (std::size_t i = 1; i < n; ++i) {
      Constraint c{.first = i - 2};
      const Law::Node by = law.node(i);
      for (std::size_t m = 0; m < 4; ++m) c.part[m] = {by.b[m] / most_[i], 0.0, 0.0};
      add(c);
    }
    return result;
  }

  // True when the samples keep the limits. Otherwise lowers them where they do not.
  bool check(const Law& law, const std::vector<Knot>& motion, SampledShares& most) {
    constexpr double kEnough = 1.002;
    const std::size_t n = law.intervals();
    std::vector<double> accel(n + 1, 1.0), jerk(n + 1, 1.0);
    Samples samples{path_, path_.first(law.s(0), start_)};
    const double end = motion.back().t;
    std::size_t knot = 0;
    for (int tick = 1; (tick - 4) * kTickSeconds < end; ++tick) {
      const double t = std::min(tick * kTickSeconds, end);
      const SampledShares now = samples.add(place(motion, t, knot));
      if (now.accel <= kEnough && now.jerk <= kEnough) continue;
      std::size_t node = std::min(knot + 1, n);
      for (;; --node) {
        accel[node] = std::max(accel[node], now.accel);
        jerk[node] = std::max(jerk[node], now.jerk);
        if (node == 0 || motion[node].t < t - 4.0 * kTickSeconds) break;
      }
    }
    most = samples.most();
    constexpr double kMargin = 1.0005;
    for (std::size_t i = 0; i <= n; ++i) {
      if (accel[i] > 1.0) accel_share_[i] /= kMargin * accel[i];
      if (jerk[i] > 1.0) jerk_share_[i] /= kMargin * jerk[i];
    }
    return most.accel <= kEnough && most.jerk <= kEnough;
  }

  Path path_;
  const TimeTable& planned_;
  double from_, to_;
  JointAngles start_, joints_at_end_{};
  std::vector<std::array<Vector, kQuantities>> slope_, bend_;
  std::vector<double> most_, accel_share_, jerk_share_;
  Solver solver_;
};

}  // namespace

OracleMotion fastest_with_jerk(const PathRig& rig, int nodes) {
  const CartesianPlan& plan = rig.planner.plan();
  OracleMotion result;
  JointAngles joints = plan.start;
  for (std::size_t first = 0; first < plan.count;) {
    std::size_t last = first;
    while (last + 1 < plan.count && joint_after(plan, last) != PathJoint::kStop) ++last;
    const CartesianSegment& end = plan.segments[last];
    Run run{rig, plan.segments[first], plan.segments[first].from, end.from + end.length, joints};
    const OracleMotion motion = run.solve(nodes);
    result.duration_s += motion.duration_s;
    result.shares = {std::max(result.shares.speed, motion.shares.speed),
                     std::max(result.shares.accel, motion.shares.accel),
                     std::max(result.shares.jerk, motion.shares.jerk)};
    joints = run.end();
    first = last + 1;
  }
  return result;
}

SampledShares shares_of_plan(const PathRig& rig, double shift) {
  const CartesianPlan& plan = rig.planner.plan();
  const Path path{rig, plan.segments[0]};
  Samples samples{path, path.first(0.0, plan.start)};
  for (std::int64_t tick = 1; tick <= plan.duration.value() + 4; ++tick) {
    static_cast<void>(samples.add(plan.table.position((static_cast<double>(tick) - shift) * kTickSeconds)));
  }
  return samples.most();
}

}  // namespace armature::test
