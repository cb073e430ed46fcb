// The controller as compiled for the host.
#pragma once

#include "controller/app/controller.hpp"
#include "controller/host_memory/memory.hpp"
#include "cosim/cpu/core_program.hpp"

namespace armature::cosim {

class HostProgram final : public CoreProgram {
 public:
  // `memory` must outlive the program.
  explicit HostProgram(host_memory::HostMemory& memory) : controller_{memory} {}

  void main(int core, CoreBus& bus) override {
    if (core == 0) {
      controller_.core0_main(bus);
    } else {
      controller_.core1_main(bus);
    }
  }

 private:
  Controller controller_;
};

}  // namespace armature::cosim
