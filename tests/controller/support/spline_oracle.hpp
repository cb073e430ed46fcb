// Splines in long double, written apart from the controller.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace armature::test {

// The natural cubic spline over the sum of chords, from the coefficients of its pieces: one dense system of equations.
struct SplineOracle {
  using Wide = Eigen::Matrix<long double, 3, 1>;

  explicit SplineOracle(const std::vector<Eigen::Vector3d>& points) {
    using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    const auto pieces = static_cast<Eigen::Index>(points.size()) - 1;
    for (Eigen::Index i = 0; i < pieces; ++i) {
      const auto k = static_cast<std::size_t>(i);
      chords.push_back((points[k + 1] - points[k]).cast<long double>().norm());
    }
    Matrix a = Matrix::Zero(4 * pieces, 4 * pieces), b = Matrix::Zero(4 * pieces, 3);
    Eigen::Index row = 0;
    const auto equation = [&](Eigen::Index piece, long double u, int order, long double sign) {
      for (int power = order; power < 4; ++power) {
        long double factor = 1;
        for (int j = 0; j < order; ++j) factor *= static_cast<long double>(power - j);
        a(row, 4 * piece + power) += sign * factor * std::pow(u, static_cast<long double>(power - order));
      }
    };
    for (Eigen::Index i = 0; i < pieces; ++i) {
      const auto k = static_cast<std::size_t>(i);
      equation(i, 0, 0, 1);
      b.row(row++) = points[k].cast<long double>().transpose();
      equation(i, chords[k], 0, 1);
      b.row(row++) = points[k + 1].cast<long double>().transpose();
    }
    for (Eigen::Index i = 0; i + 1 < pieces; ++i) {
      for (const int order : {1, 2}) {
        equation(i, chords[static_cast<std::size_t>(i)], order, 1);
        equation(i + 1, 0, order, -1);
        ++row;
      }
    }
    equation(0, 0, 2, 1);
    ++row;
    equation(pieces - 1, chords.back(), 2, 1);
    coefficients = a.fullPivLu().solve(b);
  }

  [[nodiscard]] Wide at(std::size_t piece, long double u, int order = 0) const {
    Wide result = Wide::Zero();
    for (int power = order; power < 4; ++power) {
      long double factor = std::pow(u, static_cast<long double>(power - order));
      for (int j = 0; j < order; ++j) factor *= static_cast<long double>(power - j);
      result += factor * coefficients.row(static_cast<Eigen::Index>(4 * piece) + power).transpose();
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
  Eigen::Matrix<long double, Eigen::Dynamic, 3> coefficients;
};

}  // namespace armature::test
