#include "cosim/servo/arm_model.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>

namespace armature::cosim {
namespace {

constexpr double kMPerMm = 1e-3;
constexpr double kServoRadPerDeg = 3.14159265358979323846 / 180.0;

// Standard Denavit-Hartenberg rows; the twist is a number of quarter turns.
struct DhRow {
  double a_mm, d_mm;
  int quarters;
};

std::array<DhRow, kAxes> rows_of(const KinematicsSpec& arm) {
  if (arm.family == kFiveRFamily) {
    return {{{arm.a1_mm, 0, -1}, {arm.a2_mm, 0, 0}, {arm.a3_mm, 0, 0}, {arm.a4_mm, 0, -1}, {0, arm.d5_mm, 0}, {}}};
  }
  return {{{arm.a1_mm, arm.d1_mm, 1},
           {arm.a2_mm, 0, 0},
           {arm.a3_mm, 0, 1},
           {0, arm.d4_mm, -1},
           {0, 0, 1},
           {0, arm.d6_mm, 0}}};
}

Body body_of(const BodySpec& spec) {
  const auto& [x, y, z] = spec.centre_mm;
  const auto& [xx, yy, zz, xy, xz, yz] = spec.inertia_kg_m2;
  return {spec.mass_kg, {x * kMPerMm, y * kMPerMm, z * kMPerMm}, {xx, yy, zz, xy, xz, yz}};
}

}  // namespace

ArmModel arm_model(const RobotSpec& robot) {
  if (!robot.kinematics || robot.links.size() != robot.axis_count) {
    throw std::invalid_argument{"arm: the bodies of its links are not known"};
  }
  const KinematicsSpec& arm = *robot.kinematics;
  const std::array<DhRow, kAxes> rows = rows_of(arm);
  const auto& [x, y, z] = robot.gravity_m_s2;
  ArmModel model{.joints = robot.axis_count, .links = {}, .gravity_m_s2 = {x, y, z}};
  for (std::size_t i = 0; i < model.joints; ++i) {
    model.links[i] = {.a_m = rows[i].a_mm * kMPerMm,
                      .d_m = rows[i].d_mm * kMPerMm,
                      .sin_alpha = static_cast<double>(rows[i].quarters),
                      .cos_alpha = rows[i].quarters == 0 ? 1.0 : 0.0,
                      .sign = arm.sign[i],
                      .offset_rad = arm.offset_deg[i] * kServoRadPerDeg,
                      .body = body_of(robot.links[i])};
  }
  Body& hand = model.links[model.joints - 1].body;
  hand = together(together(hand, body_of(robot.tool)), body_of(robot.payload));
  return model;
}

}  // namespace armature::cosim
