// The tags of a move or of SPEED, as numbers in the units of the program.
//
// V= is mm/s, VJ= percent, VR= deg/s. As variables they are 0.1 mm/s, 0.01 % and 0.1 deg/s.
#pragma once

#include <optional>

#include "controller/language/job/state/operand_reader.hpp"
#include "controller/language/job/state/step.hpp"

namespace armature::job {

struct MoveTags {
  static constexpr double kMaxPl = 8.0;

  std::optional<double> vj, v, vr, pl, cr, acc, dec;

  // The share of the accelerations: the smaller one of ACC and DEC, because a plan has one for both.
  [[nodiscard]] double accel_share() const noexcept;
};

// All tags behind the reader. False: the step says why.
[[nodiscard]] bool read_tags(Step& step, OperandReader operands, MoveTags& tags) noexcept;

}  // namespace armature::job
