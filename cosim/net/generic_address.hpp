// The address of a socket as the functions of the system take it.
#pragma once

#include <sys/socket.h>

namespace armature::cosim {

// `address` is a sockaddr_in or sockaddr_un.
template <class Address>
[[nodiscard]] sockaddr* generic_address(Address& address) noexcept {
  return reinterpret_cast<sockaddr*>(&address);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
}
template <class Address>
[[nodiscard]] const sockaddr* generic_address(const Address& address) noexcept {
  return reinterpret_cast<const sockaddr*>(&address);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
}

}  // namespace armature::cosim
