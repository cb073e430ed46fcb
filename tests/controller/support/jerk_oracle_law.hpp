// A law from rest to rest with continuous acceleration, for the oracle of jerk_oracle.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace armature::test::jerk_oracle {

// A point of the executed motion: between two of them its jerk is constant.
struct Knot {
  double t, s, v, a;
};

inline double place(const std::vector<Knot>& knots, double t, std::size_t& at) {
  while (at + 2 < knots.size() && knots[at + 1].t <= t) ++at;
  const Knot &a = knots[at], &b = knots[at + 1];
  if (t >= b.t) return b.s;
  const double d = t - a.t, jerk = (b.a - a.a) / (b.t - a.t);
  return a.s + d * (a.v + d * (0.5 * a.a + jerk * d / 6.0));
}

// A law from rest to rest: b over s as a quadratic spline, so the acceleration a = b' / 2 is continuous. Its unknowns x
// are coefficients of the spline, one for each interval but the first and the last, where the jerk is constant. What
// the spline takes for the length of an interval is the mean of the speeds at its ends times its duration, which makes
// the law exactly one of constant jerk in each interval.
class Law {
 public:
  explicit Law(const std::vector<double>& s) : s_{s} {
    for (std::size_t k = 0; k + 1 < s.size(); ++k) {
      h_.push_back(s[k + 1] - s[k]);
      g_.push_back(h_.back());
    }
    x_.assign(h_.size(), 0.0);
  }

  [[nodiscard]] std::size_t intervals() const { return h_.size(); }
  [[nodiscard]] double s(std::size_t node) const { return s_[node]; }
  [[nodiscard]] const std::vector<double>& nodes() const { return s_; }
  // The unknowns are 1 .. intervals() - 2.
  [[nodiscard]] double& x(std::size_t k) { return x_[k]; }
  [[nodiscard]] double x(std::size_t k) const { return x_[k]; }

  // b and a at an inner node by the unknowns node - 1 and node, those at the ends replaced by their neighbours: by
  // those at node - 2 .. node + 1.
  struct Node {
    std::array<double, 4> b{}, a{};
  };
  [[nodiscard]] Node node(std::size_t i) const {
    const double before = g_[i - 1], after = g_[i], both = before + after;
    Node node;
    put(node.b, i, 0, after / both);
    put(node.b, i, 1, before / both);
    put(node.a, i, 0, -1.0 / both);
    put(node.a, i, 1, 1.0 / both);
    return node;
  }
  [[nodiscard]] double sum(const std::array<double, 4>& by, std::size_t i) const {
    double result = 0.0;
    for (std::size_t m = 0; m < 4; ++m) {
      if (by[m] != 0.0) result += by[m] * x_[i + m - 2];
    }
    return result;
  }

  void update() {
    const std::size_t n = intervals();
    b_.assign(n + 1, 0.0);
    a_.assign(n + 1, 0.0);
    v_.assign(n + 1, 0.0);
    for (std::size_t i = 1; i < n; ++i) {
      const Node by = node(i);
      b_[i] = sum(by.b, i);
      a_[i] = sum(by.a, i);
      v_[i] = std::sqrt(std::max(b_[i], 0.0));
    }
  }
  // Valid after update().
  [[nodiscard]] double b(std::size_t i) const { return b_[i]; }
  [[nodiscard]] double a(std::size_t i) const { return a_[i]; }
  [[nodiscard]] double v(std::size_t i) const { return v_[i]; }
  [[nodiscard]] bool moves() const { return *std::min_element(b_.begin() + 1, b_.end() - 1) > 0.0; }
  [[nodiscard]] bool at_end(std::size_t k) const { return k == 0 || k + 1 == intervals(); }
  // 2 g / (v + v'), 3 h / v at the ends.
  [[nodiscard]] double weight(std::size_t k) const { return at_end(k) ? 3.0 * h_[k] : 2.0 * g_[k]; }
  [[nodiscard]] double interval_s(std::size_t k) const { return weight(k) / (v_[k] + v_[k + 1]); }
  [[nodiscard]] double time() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < intervals(); ++k) sum += interval_s(k);
    return sum;
  }

  // Sets the lengths of the spline to those of the present law, and its coefficients to the same b as near as possible.
  // Returns the largest change as a share.
  double set_lengths() {
    double most = 0.0;
    for (std::size_t k = 1; k + 1 < intervals(); ++k) {
      const double t = interval_s(k), g = h_[k] + (a_[k + 1] - a_[k]) * t * t / 12.0;
      const double next = std::clamp(g, 0.5 * h_[k], 2.0 * h_[k]);
      most = std::max(most, std::fabs(next / g_[k] - 1.0));
      g_[k] = next;
    }
    return most;
  }

  // From both ends to the node where the acceleration is smallest. One of both is slowed down to meet the other.
  [[nodiscard]] std::vector<Knot> motion() const {
    const std::size_t n = intervals();
    std::size_t middle = 1;
    for (std::size_t i = 1; i < n; ++i) {
      if (std::fabs(a_[i]) < std::fabs(a_[middle]) || (a_[i] == a_[middle] && b_[i] > b_[middle])) middle = i;
    }
    std::vector<Knot> forward{{0.0, s_[0], 0.0, 0.0}}, back{{0.0, s_[n], 0.0, 0.0}};
    for (std::size_t i = 1; i <= middle; ++i) forward.push_back(next(forward.back(), s_[i], a_[i]));
    // Backwards in time: from the end, with the opposite acceleration.
    for (std::size_t i = n; i-- > middle;) {
      Knot from = back.back();
      from.s = -from.s;
      Knot to = next(from, -s_[i], -a_[i]);
      to.s = -to.s;
      back.push_back(to);
    }
    const double slower = back.back().v / forward.back().v;
    for (Knot& k : slower > 1.0 ? back : forward) {
      const double share = slower > 1.0 ? 1.0 / slower : slower;
      k = {k.t / share, k.s, k.v * share, k.a * share * share};
    }
    const double end = forward.back().t + back.back().t;
    for (std::size_t i = back.size() - 1; i-- > 0;)
      forward.push_back({end - back[i].t, back[i].s, back[i].v, -back[i].a});
    return forward;
  }

 private:
  void put(std::array<double, 4>& by, std::size_t i, std::size_t which, double value) const {
    const std::size_t k = i - 1 + which, n = intervals();
    if (k == 0) {
      by[which + 2] += value * 0.5 * h_[0] / (g_[1] + 1.5 * h_[0]);
    } else if (k + 1 == n) {
      by[which] += value * 0.5 * h_[n - 1] / (g_[n - 2] + 1.5 * h_[n - 1]);
    } else {
      by[which + 1] += value;
    }
  }

  // After an interval of constant jerk that ends at `s` with the acceleration `a`.
  static Knot next(const Knot& from, double s, double a) {
    const double way = s - from.s;
    double t = from.v > 0.0 ? way / from.v : std::sqrt(6.0 * way / std::max(a, 1e-300));
    for (int i = 0; i < 60; ++i) {
      const double f = t * (from.v + t * (2.0 * from.a + a) / 6.0) - way, slope = from.v + t * (2.0 * from.a + a) / 3.0;
      const double step = f / slope;
      t = step < 0.5 * t ? t - step : 0.5 * t;
      if (std::fabs(step) < 1e-15 * t) break;
    }
    return {from.t + t, s, std::max(from.v + 0.5 * t * (from.a + a), 0.0), a};
  }

  std::vector<double> s_, h_, g_, x_, b_, a_, v_;
};

}  // namespace armature::test::jerk_oracle
