// Splines in long double, written apart from the controller.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace armature::test {

// The natural cubic spline over the sum of chords, from the coefficients of its pieces: one dense system of equations.
struct SplineOracle {
  using Wide = Eigen::Matrix<long double, 3, 1>;

  explicit SplineOracle(const std::vector<Eigen::Vector3d>& points) {
    const std::size_t pieces = points.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i) chords.push_back((points[i + 1] - points[i]).cast<long double>().norm());
    std::vector<Equation> equations;
    // Adds sign * the derivative of a piece to the last equation.
    const auto add = [&](std::size_t piece, long double u, int order, long double sign) {
      for (int power = order; power < 4; ++power) {
        long double factor = sign * std::pow(u, static_cast<long double>(power - order));
        for (int j = 0; j < order; ++j) factor *= static_cast<long double>(power - j);
        equations.back().factors[4 * piece + static_cast<std::size_t>(power)] += factor;
      }
    };
    const auto equate = [&](const Wide& value) {
      equations.push_back({std::vector<long double>(4 * pieces, 0), value});
    };
    for (std::size_t i = 0; i < pieces; ++i) {
      equate(points[i].cast<long double>());
      add(i, 0, 0, 1);
      equate(points[i + 1].cast<long double>());
      add(i, chords[i], 0, 1);
    }
    for (std::size_t i = 0; i + 1 < pieces; ++i) {
      for (const int order : {1, 2}) {
        equate(Wide::Zero());
        add(i, chords[i], order, 1);
        add(i + 1, 0, order, -1);
      }
    }
    equate(Wide::Zero());
    add(0, 0, 2, 1);
    equate(Wide::Zero());
    add(pieces - 1, chords.back(), 2, 1);
    coefficients = solve(std::move(equations));
  }

  [[nodiscard]] Wide at(std::size_t piece, long double u, int order = 0) const {
    Wide result = Wide::Zero();
    for (int power = order; power < 4; ++power) {
      long double factor = std::pow(u, static_cast<long double>(power - order));
      for (int j = 0; j < order; ++j) factor *= static_cast<long double>(power - j);
      result += factor * coefficients[4 * piece + static_cast<std::size_t>(power)];
    }
    return result;
  }
  // By Simpson's rule.
  [[nodiscard]] long double length(std::size_t piece, long double from, long double to) const {
    constexpr int kSteps = 200;
    const long double h = (to - from) / kSteps;
    long double sum = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const long double weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight * at(piece, from + h * i, 1).norm();
    }
    return sum * h / 3;
  }
  // The nearest point of the curve.
  [[nodiscard]] long double distance(const Eigen::Vector3d& point) const {
    long double least = std::numeric_limits<long double>::infinity();
    for (std::size_t piece = 0; piece < chords.size(); ++piece) {
      long double best = 0, step = chords[piece] / 64, least_here = std::numeric_limits<long double>::infinity();
      const auto off = [&](long double u) {
        return (at(piece, std::clamp<long double>(u, 0, chords[piece])) - point.cast<long double>()).norm();
      };
      for (int i = 0; i <= 64; ++i) {
        if (off(step * i) < least_here) best = step * i, least_here = off(best);
      }
      for (int i = 0; i < 60; ++i, step /= 2) {
        for (const long double u : {best - step, best + step}) {
          if (off(u) < least_here) best = u, least_here = off(u);
        }
      }
      least = std::min(least, least_here);
    }
    return least;
  }

  std::vector<long double> chords;
  std::vector<Wide> coefficients;  // of u^0 .. u^3 of each piece

 private:
  struct Equation {
    std::vector<long double> factors;  // of the unknowns
    Wide value;
  };

  // Gaussian elimination with pivots. Eigen's own matrices of any size are forbidden here, because they use the heap.
  static std::vector<Wide> solve(std::vector<Equation> equations) {
    const std::size_t count = equations.size();
    for (std::size_t k = 0; k < count; ++k) {
      const auto smaller = [k](const Equation& a, const Equation& b) {
        return std::fabs(a.factors[k]) < std::fabs(b.factors[k]);
      };
      const auto from = equations.begin() + static_cast<std::ptrdiff_t>(k);
      std::iter_swap(from, std::max_element(from, equations.end(), smaller));
      const Equation& pivot = equations[k];
      for (std::size_t i = 0; i < count; ++i) {
        Equation& other = equations[i];
        if (i == k || other.factors[k] == 0) continue;
        const long double share = other.factors[k] / pivot.factors[k];
        for (std::size_t j = k; j < count; ++j) other.factors[j] -= share * pivot.factors[j];
        other.value -= share * pivot.value;
      }
    }
    std::vector<Wide> unknowns;
    for (std::size_t k = 0; k < count; ++k) unknowns.push_back(equations[k].value / equations[k].factors[k]);
    return unknowns;
  }
};

}  // namespace armature::test
