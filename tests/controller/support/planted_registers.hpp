#pragma once

#include <cstdint>
#include <map>

#include "controller/hal/register_bus.hpp"

namespace armature::test {

// Registers that read a planted value until they are written: what a fault of the hardware shows.
class PlantedRegisters {
 public:
  void plant(RegAddr addr, std::uint32_t value) { values_[addr.value] = value; }
  void remove(RegAddr addr) {
    if (!values_.empty()) values_.erase(addr.value);
  }
  // What a read of the register gives, of which the logic reads `data`.
  [[nodiscard]] std::uint32_t shown(RegAddr addr, std::uint32_t data) const {
    if (values_.empty()) return data;
    const auto planted = values_.find(addr.value);
    return planted == values_.end() ? data : planted->second;
  }

 private:
  std::map<std::uint32_t, std::uint32_t> values_;  // by address
};

}  // namespace armature::test
