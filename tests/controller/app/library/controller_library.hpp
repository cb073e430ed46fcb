// The controller as a library of its own: three C functions, and a table of functions for its bus.
#pragma once

#include <cstddef>
#include <cstdint>

namespace armature::test {

// As RegisterBus.
struct BusFunctions {
  void* bus;
  std::uint32_t (*read32)(void* bus, std::uint32_t addr);
  void (*write32)(void* bus, std::uint32_t addr, std::uint32_t value);
  std::uint32_t (*wait_for_interrupt)(void* bus, std::uint32_t mask);
  void (*send_event)(void* bus);
  std::int64_t (*now)(void* bus);
  void (*charge)(void* bus, std::uint8_t work, std::int64_t times);
};

// Of a controller: how much memory it takes; constructs it there, on a host memory; the main of core 0 or 1.
using ControllerSize = std::size_t();
using ControllerConstruct = void(void* controller, void* host_memory);
using ControllerMain = void(void* controller, int core, const BusFunctions* bus);

}  // namespace armature::test
