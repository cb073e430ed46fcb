// What hears of each instruction of a core: a debugger.
#pragma once

#include <cstdint>

namespace armature::cosim::iss {

class ArmCore;

// An access of an instruction to memory or to a register of the logic.
struct DataAccess {
  std::uint32_t address = 0;
  std::uint32_t bytes = 0;
  bool write = false;
};

// Is called inside the engine, where nothing may be thrown. In before_instruction() the registers of the core may be
// read and written, and the host may wait: simulated time stands still.
class CoreWatcher {
 public:
  // The core is about to execute the instruction at `address`.
  virtual void before_instruction(ArmCore& core, std::uint32_t address) noexcept = 0;
  // The latest instruction of the core is about to make the access.
  virtual void on_data(ArmCore& core, const DataAccess& access) noexcept = 0;

 protected:
  ~CoreWatcher() = default;
};

}  // namespace armature::cosim::iss
