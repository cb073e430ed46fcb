// Register accesses to the model of the logic (cosim/model) without its bus: strobes of one clock edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "controller/hal/register_bus.hpp"
#include "cosim/model/crossbar.hpp"
#include "cosim/model/logic.hpp"

namespace armature::test {

struct BlockAccess {
  RegAddr addr;
  std::size_t port;  // of the block
  cosim::model::Strobes strobes;
};

[[noreturn]] inline void refuse_access(const char* what, RegAddr addr) {
  throw std::logic_error{std::string{"the logic refuses the "} + what + std::to_string(addr.value)};
}

// `bases`: of the blocks of the variant. Throws std::logic_error if no block has the address.
[[nodiscard]] inline std::size_t port_of_block(RegAddr addr, std::span<const std::uint32_t> bases) {
  const std::optional<std::size_t> port = cosim::model::port_of(addr.value, bases);
  if (!port) refuse_access("access to ", addr);
  return *port;
}
[[nodiscard]] inline BlockAccess block_read(RegAddr addr, std::span<const std::uint32_t> bases) {
  return {addr, port_of_block(addr, bases), {.read = true, .raddr = static_cast<std::uint16_t>(addr.value)}};
}
[[nodiscard]] inline BlockAccess block_write(RegAddr addr, std::uint32_t value, std::span<const std::uint32_t> bases) {
  return {addr,
          port_of_block(addr, bases),
          {.write = true, .waddr = static_cast<std::uint16_t>(addr.value), .wdata = value, .wstrb = 0xF}};
}

// What a read returns. Throws std::logic_error if the block refuses the access.
inline std::uint32_t data_of(const BlockAccess& access, const cosim::model::Answer& answer) {
  if (access.strobes.read && answer.rerr) refuse_access("read of ", access.addr);
  if (access.strobes.write && answer.werr) refuse_access("write of ", access.addr);
  return answer.rdata;
}

}  // namespace armature::test
