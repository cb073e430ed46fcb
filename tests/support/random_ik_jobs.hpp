// Random contents of the registers of ik_cordic: arms that reach, arms at their limits, and any words at all.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cosim/model/ik_cordic/ik_solver.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {

class RandomIkJobs {
 public:
  explicit RandomIkJobs(std::uint64_t seed) : random_{seed} {}

  cosim::model::ik::Job next() {
    cosim::model::ik::Job job;
    job.five_r = random_.below(2) == 0;
    // Rotations are any unit-sized entries here: the block does not know whether they are orthonormal.
    const bool wild = random_.below(4) == 0;
    for (std::int32_t& entry : job.rotation) entry = wild ? word() : entry_of_a_rotation();
    for (std::int32_t& coordinate : job.position) coordinate = wild ? word() : length(28);
    job.upper = link();
    job.fore = random_.below(4) == 0 ? job.upper : link();
    if (!wild && random_.below(4) != 0) {
      job.a1 = length(22);
      job.base = length(26);
      job.a4 = length(25);
      job.hand = length(26);
    } else if (random_.below(2) == 0) {
      job.a1 = word();
      job.base = word();
      job.a4 = word();
      job.hand = word();
    }
    if (random_.below(8) == 0) put_at_the_reach(job);
    job.phi = word();
    job.previous1 = word();
    job.previous2 = word();
    job.previous4 = word();
    return job;
  }

 private:
  // Any word, and often one of the extremes.
  std::int32_t word() {
    constexpr std::int32_t kExtremes[] = {0, 1, -1, INT32_MAX, INT32_MIN, INT32_MIN + 1, 1 << 30, -(1 << 30)};
    if (random_.below(3) == 0) return kExtremes[random_.below(8)];
    return static_cast<std::int32_t>(random_.next()) >> (random_.below(3) == 0 ? random_.below(32) : 0);
  }
  // Below 2^bits, positive or negative.
  std::int32_t length(unsigned bits) { return static_cast<std::int32_t>(random_.next()) >> (31 - bits); }
  std::uint32_t link() {
    constexpr std::uint32_t kLargest = (1u << 29) - 1;
    switch (random_.below(8)) {
      case 0:
        return kLargest - random_.below(2);
      case 1:
        return random_.below(2);
      default:
        return random_.below(kLargest);
    }
  }
  std::int32_t entry_of_a_rotation() {
    switch (random_.below(8)) {
      case 0:
        return 1 << 30;
      case 1:
        return -(1 << 30);
      case 2:
        return static_cast<std::int32_t>(random_.below(5)) - 2;
      default:
        return length(30);
    }
  }
  // The tool straight above axis 1 and 2, as far away as both links, or as their difference.
  void put_at_the_reach(cosim::model::ik::Job& job) {
    const bool far = random_.below(2) == 0;
    job.a1 = job.base = job.a4 = job.hand = 0;
    const auto [shorter, longer] = std::minmax(job.upper, job.fore);
    const std::uint32_t distance = far ? longer + shorter : longer - shorter;
    job.position = {0, 0, 0};
    job.position[random_.below(3)] = static_cast<std::int32_t>(distance + random_.below(9)) - 4;
  }

  SplitMix random_;
};

}  // namespace armature::test
