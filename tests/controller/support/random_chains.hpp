// Random chains of moves for every arm: from micrometres to decimetres, next to joint limits and through the wrist
// singularity, lines, arcs, circles and turns.
#pragma once

#include <cmath>
#include <vector>

#include "controller/robot/robot_model.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/random.hpp"

namespace armature::test {

enum class Laws { kTrapezoids, kSCurves, kMixed };
enum class Begin { kAnywhere, kNearLimits, kNearWrist };

struct RandomChain {
  RobotModel robot;  // of the file, its accelerations and jerks scaled
  Transform tool{};  // on the flange
  JointAngles start{};
  std::vector<SegmentRequest> requests;
  bool exact = true;  // poses are ones that the arm reaches, not turned into its plane
  PathLimits most{};  // the largest limits of any request
};

inline double log_uniform(Random& random, double low, double high) {
  return std::exp(random.real(std::log(low), std::log(high)));
}

// One coordinate a statement: the order in which arguments are evaluated differs between compilers.
inline Eigen::Vector3d random_vector(Random& random, double size) {
  Eigen::Vector3d v;
  for (double& x : v) x = random.real(-size, size);
  return v;
}

class ChainMaker {
 public:
  ChainMaker(Random& random, const RobotModel& robot, Laws laws, bool blended, Begin begin)
      : random_{random}, laws_{laws}, blended_{blended}, begin_{begin} {
    chain_.robot = robot;
  }

  [[nodiscard]] RandomChain make() {
    scale_robot();
    mount_tool();
    size_mm_ = log_uniform(random_, 1e-3, 100.0);
    turn_rad_ = log_uniform(random_, 1e-3, begin_ == Begin::kNearWrist ? 0.1 : 1.0);
    blend_mm_ = size_mm_ * log_uniform(random_, 1e-3, 3.0);
    paces_ = log_uniform(random_, 0.2, 5.0);
    const Arm arm{chain_.robot};
    stand();
    Transform at = arm.forward(chain_.start) * chain_.tool;
    if (begin_ == Begin::kNearWrist && six()) at = pass_the_wrist(arm, at);
    const std::int64_t most = random_.integer(1, 3);
    while (chain_.requests.empty() || static_cast<std::int64_t>(chain_.requests.size()) < most) at = add(at);
    return chain_;
  }

 private:
  [[nodiscard]] bool six() const { return chain_.robot.arm.family == ArmFamily::kSixR; }

  // A quarter of the chains as the file has them, the others on a stronger arm: they take fewer ticks and bend more.
  void scale_robot() {
    const double k = random_.integer(0, 3) == 0 ? 1.0 : random_.real(1.0, 5.0);
    for (AxisModel& axis : chain_.robot.axes) {
      axis.max_accel_rad_s2 *= k * k;
      axis.max_jerk_rad_s3 *= k * k * k;
    }
    scale_ = k;
  }

  void mount_tool() {
    const double roll = random_.real(-0.5, 0.5);
    const double pitch = random_.real(-0.5, 0.5);
    const double yaw = random_.real(-3.0, 3.0);
    chain_.tool.position_mm = random_vector(random_, 60.0);
    if (random_.integer(0, 3) != 0) chain_.tool.rotation = rotation_from_rpy(roll, pitch, yaw);
    if (six()) return;
    // A five-axis arm turns other orientations into its plane, or is asked for those of its plane only.
    projects_ = random_.integer(0, 1) == 0;
    if (projects_) chain_.robot.arm.max_projection_rad = 1.0;
    chain_.exact = !projects_;
  }

  void stand() {
    for (std::size_t i = 0; i < chain_.robot.axis_count; ++i) {
      const AxisModel& axis = chain_.robot.axes[i];
      const double margin = 0.1 * (axis.max_rad - axis.min_rad);
      chain_.start[i] = Radians{random_.real(axis.min_rad + margin, axis.max_rad - margin)};
    }
    if (begin_ == Begin::kNearLimits) {
      const auto i =
          static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(chain_.robot.axis_count) - 1));
      const double away_rad = log_uniform(random_, 1e-8, 0.1);
      const AxisModel& axis = chain_.robot.axes[i];
      chain_.start[i] = Radians{random_.integer(0, 1) == 0 ? axis.min_rad + away_rad : axis.max_rad - away_rad};
    }
    if (begin_ == Begin::kNearWrist && six()) {
      // theta_5 = +- q_5 of all arms.
      const double away_rad =
          random_.integer(0, 4) == 0 ? log_uniform(random_, 1e-15, 1e-6) : log_uniform(random_, 1e-6, 1e-2);
      chain_.start[4] = Radians{random_.integer(0, 1) == 0 ? away_rad : -away_rad};
    }
  }

  // The first move has the singular posture in its middle; returns its end.
  Transform pass_the_wrist(const Arm& arm, const Transform& middle) {
    const Eigen::Vector3d half_mm = random_vector(random_, random_.integer(0, 1) == 0 ? 0.0 : size_mm_);
    const Eigen::Vector3d axis = random_vector(random_, 1.0);
    const double half_rad = 0.5 * turn_rad_;
    const Transform from{turned_by(middle, -half_rad, axis).rotation, middle.position_mm - half_mm};
    Transform to{turned_by(middle, half_rad, axis).rotation, middle.position_mm + half_mm};
    const IkTracking start = arm.track(from * inverse(chain_.tool), chain_.start);
    if (!solved(start.status)) return middle;  // a chain that begins in the singularity instead
    chain_.start = start.joints;
    chain_.requests.push_back(next_line(to));
    return to;
  }

  Transform add(Transform at) {
    const Transform from = at;
    const std::int64_t shape = random_.integer(0, 7);  // 0: turns, 1: moves, 2 and 3: round, 4: back
    const Eigen::Vector3d via_mm = at.position_mm + random_vector(random_, size_mm_);
    const Eigen::Vector3d way_mm = random_vector(random_, size_mm_);
    const double angle_rad = turn_rad_ * random_.real(0.1, 1.0);
    const Eigen::Vector3d axis = random_vector(random_, 1.0);
    if (shape != 0) at.position_mm += way_mm;
    if (shape != 1) at = turned_by(at, angle_rad, axis);
    if (shape == 4 && !chain_.requests.empty()) at.position_mm = from.position_mm - last_mm_;
    // Back at the start of a circle five joints have the orientation that they had there.
    if (!six() && !projects_) at = shape == 3 ? Transform{from.rotation, at.position_mm} : in_plane(at);
    SegmentRequest request = next_line(at);
    if (shape == 2 || shape == 3) {
      request.kind = shape == 2 ? SegmentRequest::Kind::kArc : SegmentRequest::Kind::kCircle;
      request.via_mm = via_mm;
    }
    chain_.requests.push_back(request);
    if (shape == 3) at.position_mm = from.position_mm;
    last_mm_ = at.position_mm - from.position_mm;
    return at;
  }

  // The nearest pose that five joints reach exactly; beyond reach or limits the pose itself, most often for a refusal.
  [[nodiscard]] Transform in_plane(const Transform& tool) {
    RobotModel tolerant = chain_.robot;
    tolerant.arm.max_projection_rad = 3.0;
    const Arm arm{tolerant};
    const IkTracking there = arm.track(tool * inverse(chain_.tool), chain_.start);
    if (!solved(there.status)) {
      chain_.exact = false;
      return tool;
    }
    return arm.forward(there.joints) * chain_.tool;
  }

  SegmentRequest next_line(const Transform& to) {
    const PathLimits limits = next_limits();
    const double blend_mm = next_blend_mm();
    const ProfileKind profile = next_profile();
    return line_to(to, limits, blend_mm, profile);
  }
  PathLimits next_limits() {
    const double k = scale_ * paces_;
    const double slow = random_.integer(0, 3) == 0 ? random_.real(0.2, 1.0) : 1.0;
    const PathLimits limits{.speed_mm_s = 700.0 * paces_ * slow,
                            .accel_mm_s2 = 5'000.0 * scale_ * k * slow,
                            .jerk_mm_s3 = 2e5 * scale_ * scale_ * k * slow,
                            .turn_speed_rad_s = 6.0 * paces_ * slow,
                            .turn_accel_rad_s2 = 40.0 * scale_ * k * slow,
                            .turn_jerk_rad_s3 = 1'600.0 * scale_ * scale_ * k * slow};
    const auto widen = [](double& most, double value) { most = std::max(most, value); };
    widen(chain_.most.speed_mm_s, limits.speed_mm_s);
    widen(chain_.most.accel_mm_s2, limits.accel_mm_s2);
    widen(chain_.most.jerk_mm_s3, limits.jerk_mm_s3);
    widen(chain_.most.turn_speed_rad_s, limits.turn_speed_rad_s);
    widen(chain_.most.turn_accel_rad_s2, limits.turn_accel_rad_s2);
    widen(chain_.most.turn_jerk_rad_s3, limits.turn_jerk_rad_s3);
    return limits;
  }
  double next_blend_mm() { return blended_ && random_.integer(0, 4) != 0 ? blend_mm_ : 0.0; }
  ProfileKind next_profile() {
    if (laws_ == Laws::kMixed) return random_.integer(0, 1) == 0 ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
    return laws_ == Laws::kSCurves ? ProfileKind::kSCurve : ProfileKind::kTrapezoid;
  }

  Random& random_;
  Laws laws_;
  bool blended_;
  Begin begin_;
  RandomChain chain_;
  double size_mm_ = 0.0, turn_rad_ = 0.0, blend_mm_ = 0.0, paces_ = 1.0, scale_ = 1.0;
  bool projects_ = false;
  Eigen::Vector3d last_mm_ = Eigen::Vector3d::Zero();
};

}  // namespace armature::test
