// Random legal traffic on every pin of arm_soc: reads of every register after reset, then random reads and writes
// of all blocks with random stalls, while the other inputs change at random.
#pragma once

#include <cstdint>

#include "cosim/fabric/fabric.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {

class RandomSession {
 public:
  struct Write {
    std::uint32_t addr, data;
  };

  explicit RandomSession(std::uint64_t seed) : random_{seed} {}

  // Runs `fabric` for `clocks`. It must be at cycle 0.
  void run(cosim::Fabric& fabric, std::int64_t clocks);

 private:
  void drive_bus(const cosim::AxiSlavePins& before);
  void drive_pins();
  Write useful_write();
  std::uint32_t address();
  std::uint32_t data();

  SplitMix random_;
  cosim::AxiMasterPins master_;
  cosim::SocInputs inputs_;
  std::uint32_t sweep_ = 0;                // number of words of the sweep that have been read
  std::uint32_t set_up_ = 0;               // number of start-up writes that have been issued
  bool aw_done_ = false, w_done_ = false;  // the address, the data of the write in flight have been accepted
  bool writing_ = false, reading_ = false;
};

}  // namespace armature::test
