// The time of a processor that runs ahead of all else (cosim/cpu/run_ahead.hpp).
#pragma once

#include "controller/base/units.hpp"

namespace armature::cosim {

struct TimeAhead {
  Cycles now{};
  Cycles horizon{};  // before it nothing but the processor happens
};

}  // namespace armature::cosim
