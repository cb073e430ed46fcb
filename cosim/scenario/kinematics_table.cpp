#include "cosim/scenario/kinematics_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kLongestMm = 10'000;  // far beyond any arm
// The shortest upper arm and forearm: below it two joints would turn about one axis.
constexpr double kShortestMm = 0.001;
// Below this the rounding of a pose that the arm can reach would already count as out of its reach.
constexpr double kLeastProjectionDeg = 1e-9;

constexpr std::string_view kOtherArm = "joint moves work without [kinematics]";

const Rule kOffset = between(-kLongestMm, kLongestMm, "mm");
const Rule kLink = between(kShortestMm, kLongestMm, "mm");

// One number a joint, `count` of them.
bool read_joints(TableReader& table, std::string_view key, const Rule& rule, std::size_t count, PerAxis<double>& out) {
  std::vector<double> numbers;
  if (!table.read(key, numbers, rule, Need::kRequired)) return false;
  if (numbers.size() != count) {
    table.problem(key, "expected " + expected_array(ValueKind::kNumber, rule, count) + ", found " +
                           std::to_string(numbers.size()));
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) out[i] = numbers[i];
  return true;
}

void read_six_r(TableReader& table, KinematicsSpec& kinematics) {
  table.read("a1_mm", kinematics.a1_mm, kOffset, Need::kRequired);
  table.read("a2_mm", kinematics.a2_mm, kLink, Need::kRequired);
  const bool has_a3 = table.read("a3_mm", kinematics.a3_mm, kOffset, Need::kRequired);
  table.read("d1_mm", kinematics.d1_mm, kOffset, Need::kRequired);
  const bool has_d4 = table.read("d4_mm", kinematics.d4_mm, kOffset, Need::kRequired);
  table.read("d6_mm", kinematics.d6_mm, kOffset, Need::kRequired);
  table.refuse({"a4_mm", "d5_mm", "max_projection_deg"}, "family = \"five_r\"");
  table.reject({"a5_mm", "a6_mm"},
               fmt::format("an offset in the wrist, whose axes meet in one point in this family; {}", kOtherArm));
  if (has_a3 && has_d4 && std::hypot(kinematics.a3_mm, kinematics.d4_mm) < kShortestMm) {
    table.problem("d4_mm", "with a3_mm it makes a forearm of " +
                               number_text(std::hypot(kinematics.a3_mm, kinematics.d4_mm)) + " mm, expected at least " +
                               number_text(kShortestMm) + " (the elbow would be the wrist)");
  }
}

void read_five_r(TableReader& table, KinematicsSpec& kinematics) {
  table.read("a1_mm", kinematics.a1_mm, kOffset, Need::kRequired);
  table.read("a2_mm", kinematics.a2_mm, kLink, Need::kRequired);
  table.read("a3_mm", kinematics.a3_mm, kLink, Need::kRequired);
  table.read("a4_mm", kinematics.a4_mm, kOffset, Need::kRequired);
  table.read("d5_mm", kinematics.d5_mm, kOffset, Need::kRequired);
  table.read("max_projection_deg", kinematics.max_projection_deg, between(kLeastProjectionDeg, 90, "deg"));
  table.refuse({"d1_mm", "d4_mm", "d6_mm"}, "family = \"six_r\"");
}

}  // namespace

void read_kinematics(TableReader& table, KinematicsSpec& kinematics) {
  Rule family = one_of({kSixRFamily, kFiveRFamily});
  family.otherwise = kOtherArm;
  if (!table.read("family", kinematics.family, family, Need::kRequired)) {
    table.ignore_rest();
    return;
  }
  kinematics.family == kSixRFamily ? read_six_r(table, kinematics) : read_five_r(table, kinematics);
  // What resembles a family and is none.
  table.reject({"d2_mm", "d3_mm"},
               fmt::format("a shoulder offset, the arm beside axis 1, which no family has; {}", kOtherArm));
  const std::size_t joints = joints_of(kinematics.family);
  if (read_joints(table, "sign", anything(), joints, kinematics.sign)) {
    for (std::size_t i = 0; i < joints; ++i) {
      if (std::fabs(kinematics.sign[i]) == 1.0) continue;
      table.problem(
          "sign", "expected 1 or -1 for joint " + std::to_string(i + 1) + ", found " + number_text(kinematics.sign[i]));
    }
  }
  read_joints(table, "offset_deg", between(-360, 360, "deg"), joints, kinematics.offset_deg);
}

}  // namespace armature::cosim
