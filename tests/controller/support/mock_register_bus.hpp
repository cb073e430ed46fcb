// A register bus on which every access must be expected.
#pragma once

#include <gmock/gmock.h>

#include <ostream>

#include "controller/hal/register_bus.hpp"

namespace armature {

inline void PrintTo(RegAddr addr, std::ostream* out) {
  *out << "0x" << std::hex << addr.value << std::dec;
}

namespace test {

class MockRegisterBus : public RegisterBus {
 public:
  virtual ~MockRegisterBus() = default;

  MOCK_METHOD(std::uint32_t, read32, (RegAddr), (noexcept, override));
  MOCK_METHOD(void, write32, (RegAddr, std::uint32_t), (noexcept, override));
  MOCK_METHOD(Interrupts, wait_for_interrupt, (Interrupts), (noexcept, override));
  MOCK_METHOD(void, send_event, (), (noexcept, override));
  MOCK_METHOD(Cycles, now, (), (noexcept, override));
  MOCK_METHOD(void, charge, (Work, std::int64_t), (noexcept, override));
};

}  // namespace test
}  // namespace armature
