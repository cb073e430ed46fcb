#include "cosim/servo/load_side.hpp"

#include <cmath>
#include <cstddef>

namespace armature::cosim {
namespace {

// The inverse of a symmetric positive matrix of the first `size` joints by Cholesky's method: M = L L^T.
JointMatrix inverse_of(const JointMatrix& matrix, std::size_t size) {
  JointMatrix lower{}, result{};  // `lower`: below the diagonal L, on it 1 / L
  for (std::size_t j = 0; j < size; ++j) {
    double square = matrix[j][j];
    for (std::size_t k = 0; k < j; ++k) square -= lower[j][k] * lower[j][k];
    lower[j][j] = 1.0 / std::sqrt(square);
    for (std::size_t i = j + 1; i < size; ++i) {
      double sum = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      lower[i][j] = sum * lower[j][j];
    }
  }
  // L^-1, then M^-1 = L^-T L^-1.
  JointMatrix unlower{};
  for (std::size_t j = 0; j < size; ++j) {
    unlower[j][j] = lower[j][j];
    for (std::size_t i = j + 1; i < size; ++i) {
      double sum = 0.0;
      for (std::size_t k = j; k < i; ++k) sum -= lower[i][k] * unlower[k][j];
      unlower[i][j] = sum * lower[i][i];
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (std::size_t k = i; k < size; ++k) sum += unlower[k][i] * unlower[k][j];
      result[i][j] = result[j][i] = sum;
    }
  }
  return result;
}

PerAxis<double> plain(const AxisNumbers& numbers) {
  return make_per_axis([&](std::size_t axis) { return numbers[axis]; });
}

}  // namespace

LoadSide::State LoadSide::at(const AxisNumbers& angles, const AxisNumbers& speeds) {
  arm_.set_posture(plain(angles));
  const JointMatrix inverse = inverse_of(arm_.mass_matrix(), arm_.joints());
  const PerAxis<double> bias = arm_.bias(plain(speeds));
  State state;
  for (std::size_t i = 0; i < kAxes; ++i) {
    state.bias[i] = bias[i];
    for (std::size_t j = 0; j < kAxes; ++j) state.inverse[i][j] = inverse[i][j];
  }
  return state;
}

PerAxis<double> LoadSide::gravity(const PerAxis<double>& angles) {
  arm_.set_posture(angles);
  return arm_.gravity();
}

}  // namespace armature::cosim
