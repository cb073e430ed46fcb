// Vectors and matrices of three dimensions in plain arithmetic of doubles, in a written order: the same bits on every
// machine and with every compiler.
#pragma once

#include <array>
#include <cstddef>

namespace armature::cosim {

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;

  friend constexpr Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector3 operator*(double s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

[[nodiscard]] constexpr double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A symmetric matrix, such as an inertia tensor.
struct Symmetric3 {
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;

  friend constexpr Symmetric3 operator+(const Symmetric3& a, const Symmetric3& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
  }
  friend constexpr Vector3 operator*(const Symmetric3& m, const Vector3& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
  }
};

// Inertia of a point mass 1 at `r`: r^2 E - r r^T.
[[nodiscard]] constexpr Symmetric3 of_point(const Vector3& r) {
  return {r.y * r.y + r.z * r.z, r.x * r.x + r.z * r.z, r.x * r.x + r.y * r.y,
          -(r.x * r.y),          -(r.x * r.z),          -(r.y * r.z)};
}

// The rotation of a Denavit-Hartenberg row, from the frame of a link to the one below it: Rz(theta) Rx(alpha).
struct LinkRotation {
  double sin = 0.0, cos = 1.0;              // of theta
  double sin_alpha = 0.0, cos_alpha = 1.0;  // alpha: twist of the link

  // From the frame of the link to the one below it.
  [[nodiscard]] constexpr Vector3 down(const Vector3& v) const {
    const double y = cos_alpha * v.y - sin_alpha * v.z;
    return {cos * v.x - sin * y, sin * v.x + cos * y, sin_alpha * v.y + cos_alpha * v.z};
  }
  // From the frame below to that of the link.
  [[nodiscard]] constexpr Vector3 up(const Vector3& v) const {
    const double y = cos * v.y - sin * v.x;
    return {cos * v.x + sin * v.y, cos_alpha * y + sin_alpha * v.z, cos_alpha * v.z - sin_alpha * y};
  }
  // R m R^T.
  [[nodiscard]] constexpr Symmetric3 down(const Symmetric3& m) const {
    const Vector3 a = down(Vector3{m.xx, m.xy, m.xz});
    const Vector3 b = down(Vector3{m.xy, m.yy, m.yz});
    const Vector3 c = down(Vector3{m.xz, m.yz, m.zz});
    const Vector3 x = down(Vector3{a.x, b.x, c.x}), y = down(Vector3{a.y, b.y, c.y}), z = down(Vector3{a.z, b.z, c.z});
    return {x.x, y.y, z.z, x.y, x.z, y.z};
  }
};

}  // namespace armature::cosim
