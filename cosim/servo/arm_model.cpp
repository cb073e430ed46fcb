#include "cosim/servo/arm_model.hpp"

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "controller/base/angle_units.hpp"
#include "cosim/robot/dh_rows.hpp"

namespace armature::cosim {
namespace {

constexpr double kMPerMm = 1e-3;

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
  const std::vector<DhRow> rows = dh_rows(arm);
  const auto& [x, y, z] = robot.gravity_m_s2;
  ArmModel model{.joints = robot.axis_count, .links = {}, .gravity_m_s2 = {x, y, z}};
  for (std::size_t i = 0; i < model.joints; ++i) {
    model.links[i] = {.a_m = rows[i].a_mm * kMPerMm,
                      .d_m = rows[i].d_mm * kMPerMm,
                      .sin_alpha = static_cast<double>(rows[i].alpha_quarters),
                      .cos_alpha = rows[i].alpha_quarters == 0 ? 1.0 : 0.0,
                      .sign = arm.sign[i],
                      .offset_rad = arm.offset_deg[i] * kRadPerDeg,
                      .body = body_of(robot.links[i])};
  }
  Body& hand = model.links[model.joints - 1].body;
  hand = together(together(hand, body_of(robot.tool)), body_of(robot.payload));
  return model;
}

}  // namespace armature::cosim
