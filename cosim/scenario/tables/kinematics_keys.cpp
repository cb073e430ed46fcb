// [kinematics] of a robot file.
#include <cmath>
#include <cstddef>
#include <string>

#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kLongestMm = 10'000;  // far beyond any arm
// The shortest upper arm and forearm: below it two joints would turn about one axis.
constexpr double kShortestMm = 0.001;
// With less, a reachable pose could be refused because of rounding.
constexpr double kLeastProjectionDeg = 1e-9;

constexpr std::string_view kOtherArm = "joint moves work without [kinematics]";
constexpr std::string_view kWristOffset =
    "an offset in the wrist, whose axes meet in one point in this family; joint moves work without [kinematics]";
constexpr std::string_view kShoulderOffset =
    "a shoulder offset, the arm beside axis 1, which no family has; joint moves work without [kinematics]";

const Condition kSixR = when("family", {kSixRFamily});
const Condition kFiveR = when("family", {kFiveRFamily});
const Condition kBoth = when("family", {kSixRFamily, kFiveRFamily});

Rule family() {
  Rule rule = one_of({kSixRFamily, kFiveRFamily});
  rule.otherwise = kOtherArm;
  return rule;
}

Key<KinematicsSpec> offset(std::string_view name, double KinematicsSpec::*member, const Condition& condition) {
  return key(name, member, between(-kLongestMm, kLongestMm, "mm"), "Denavit-Hartenberg length.")
      .required()
      .only(condition);
}
Key<KinematicsSpec> link(std::string_view name, double KinematicsSpec::*member, const Condition& condition) {
  return key(name, member, between(kShortestMm, kLongestMm, "mm"),
             "Denavit-Hartenberg length of a link, which must be above 0.")
      .required()
      .only(condition);
}

// One number for each joint of the family.
Key<KinematicsSpec> joints(std::string_view name, PerAxis<double> KinematicsSpec::*member, Rule rule,
                           std::string_view family, std::string_view text) {
  rule.count = joints_of(family);
  return key(name, member, rule, text).required().only(when("family", {family}));
}
Key<KinematicsSpec> sign_key(std::string_view family) {
  return joints("sign", &KinematicsSpec::sign, one_of_numbers({1, -1}), family,
                "Direction of each joint: theta = `sign` * joint angle + `offset_deg`.");
}
Key<KinematicsSpec> offset_key(std::string_view family) {
  return joints("offset_deg", &KinematicsSpec::offset_deg, between(-360, 360, "deg"), family,
                "Angle theta of each joint at joint angle 0.");
}

void check_forearm(TableReader& table, const KeyContext&, const KinematicsSpec& kinematics) {
  const double forearm = std::hypot(kinematics.a3_mm, kinematics.d4_mm);
  if (kinematics.family != kSixRFamily || forearm >= kShortestMm) return;
  table.problem("d4_mm", "with a3_mm it makes a forearm of " + number_text(forearm) + " mm, expected at least " +
                             number_text(kShortestMm) + " (the elbow would be the wrist)");
}

}  // namespace

const KeyTable<KinematicsSpec>& kinematics_keys() {
  static const KeyTable<KinematicsSpec> kTable{
      .text = "Geometry of the arm. Moves to poses need it. An arm without it has joint moves only.",
      .keys =
          {
              key("family", &KinematicsSpec::family, family(),
                  "Kind of arm. `six_r`: six joints with a spherical wrist, Vo 2021 Table 2. `five_r`: five joints, Hu "
                  "2012 Table 1.")
                  .required(),
              offset("a1_mm", &KinematicsSpec::a1_mm, kBoth),
              link("a2_mm", &KinematicsSpec::a2_mm, kBoth),
              offset("a3_mm", &KinematicsSpec::a3_mm, kSixR),
              link("a3_mm", &KinematicsSpec::a3_mm, kFiveR),
              offset("a4_mm", &KinematicsSpec::a4_mm, kFiveR),
              offset("d1_mm", &KinematicsSpec::d1_mm, kSixR),
              offset("d4_mm", &KinematicsSpec::d4_mm, kSixR),
              offset("d5_mm", &KinematicsSpec::d5_mm, kFiveR),
              offset("d6_mm", &KinematicsSpec::d6_mm, kSixR),
              sign_key(kSixRFamily),
              sign_key(kFiveRFamily),
              offset_key(kSixRFamily),
              offset_key(kFiveRFamily),
              key("max_projection_deg", &KinematicsSpec::max_projection_deg, between(kLeastProjectionDeg, 90, "deg"),
                  "Largest angle between the orientation of a pose and the nearest orientation that five joints reach. "
                  "A pose beyond it is refused.")
                  .only(kFiveR),
              refused_key<KinematicsSpec>("d2_mm", kShoulderOffset).only(kBoth),
              refused_key<KinematicsSpec>("d3_mm", kShoulderOffset).only(kBoth),
              refused_key<KinematicsSpec>("a5_mm", kWristOffset).only(kSixR),
              refused_key<KinematicsSpec>("a6_mm", kWristOffset).only(kSixR),
          },
      .checks = {{{"a3_mm", "d4_mm"}, check_forearm}}};
  return kTable;
}

}  // namespace armature::cosim
