// The motion of the belt that [conveyor] describes, in closed form.
#pragma once

#include <cstdint>
#include <vector>

#include "cosim/belt/conveyor_spec.hpp"

namespace armature::cosim {

class BeltMotion {
 public:
  explicit BeltMotion(const ConveyorSpec& spec);

  // The distance that the belt has moved since the start, at a time >= 0.
  [[nodiscard]] double position_mm(double t_s) const;
  // The count of its encoder, or of a camera that is wrong by `error_mm`.
  [[nodiscard]] std::int64_t counts(double t_s, double error_mm = 0) const;
  // The same of a part since it passed the sync point, by its index in ConveyorSpec::part_s.
  [[nodiscard]] double displacement_mm(std::size_t part, double t_s) const;

 private:
  // Constant acceleration from its start to that of the next one.
  struct Section {
    double from_s = 0;
    double position_mm = 0;
    double speed_mm_s = 0;
    double accel_mm_s2 = 0;

    [[nodiscard]] double position_at(double t_s) const;
    [[nodiscard]] double speed_at(double t_s) const;
  };
  void add(double from_s, double accel_mm_s2);

  ConveyorSpec spec_;
  std::vector<Section> sections_;
};

}  // namespace armature::cosim
