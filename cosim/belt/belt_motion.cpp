#include "cosim/belt/belt_motion.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "controller/base/math.hpp"

namespace armature::cosim {

double BeltMotion::Section::position_at(double t_s) const {
  const double dt = t_s - from_s;
  return position_mm + dt * (speed_mm_s + 0.5 * accel_mm_s2 * dt);
}

double BeltMotion::Section::speed_at(double t_s) const {
  return speed_mm_s + accel_mm_s2 * (t_s - from_s);
}

BeltMotion::BeltMotion(const ConveyorSpec& spec) : spec_{spec}, sections_{{.speed_mm_s = spec.speed_mm_s}} {
  for (std::size_t i = 0; i < spec.speeds.size(); ++i) {
    const BeltSpeedSpec& change = spec.speeds[i];
    const double next_s =
        i + 1 < spec.speeds.size() ? spec.speeds[i + 1].at_s : std::numeric_limits<double>::infinity();
    const double difference = change.speed_mm_s - sections_.back().speed_at(change.at_s);
    const double end_s = change.at_s + std::fabs(difference) / spec.belt_accel_mm_s2;
    add(change.at_s, std::copysign(spec.belt_accel_mm_s2, difference));
    if (end_s >= next_s) continue;
    add(end_s, 0);
    sections_.back().speed_mm_s = change.speed_mm_s;
  }
}

void BeltMotion::add(double from_s, double accel_mm_s2) {
  const Section& last = sections_.back();
  sections_.push_back({.from_s = from_s,
                       .position_mm = last.position_at(from_s),
                       .speed_mm_s = last.speed_at(from_s),
                       .accel_mm_s2 = accel_mm_s2});
}

double BeltMotion::position_mm(double t_s) const {
  std::size_t section = 0;
  while (section + 1 < sections_.size() && sections_[section + 1].from_s <= t_s) ++section;
  const double mm = sections_[section].position_at(t_s);
  return mm + spec_.wave_mm * math::sin(2.0 * std::numbers::pi / spec_.wave_length_mm * mm);
}

std::int64_t BeltMotion::counts(double t_s, double error_mm) const {
  return static_cast<std::int64_t>(std::floor((position_mm(t_s) + error_mm) / spec_.mm_per_count));
}

double BeltMotion::displacement_mm(std::size_t part, double t_s) const {
  return position_mm(t_s) - position_mm(spec_.part_s.at(part));
}

}  // namespace armature::cosim
