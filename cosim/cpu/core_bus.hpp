// The bus of a simulated core, as its program sees it.
#pragma once

#include "controller/hal/register_bus.hpp"

namespace armature::cosim {

class CoreBus : public RegisterBus {
 public:
  // The core computes for this time, of a program that measures what it computes. Zero: nothing happens.
  virtual void pass(Cycles duration) noexcept = 0;

 protected:
  ~CoreBus() = default;
};

}  // namespace armature::cosim
