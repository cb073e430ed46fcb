// --on of `ik`: the three ways of Hu 2012 to the joint angles of a pose.
#pragma once

#include <cstdint>

namespace armature::cosim {

enum class SolvedOn : std::uint8_t {
  kHost,    // the program itself: the paper has Matlab
  kA9,      // the firmware on a Cortex-A9: the paper has a C program on a Nios II
  kCordic,  // the block ik_cordic
};

}  // namespace armature::cosim
