// A command or an event in its slot of a ring: the number of its type and its bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "controller/host_memory/wire.hpp"

namespace armature::host_memory {

template <class Variant>
struct Slot;

template <class... Messages>
struct Slot<std::variant<Messages...>> {
  using Variant = std::variant<Messages...>;
  static constexpr std::size_t kSize = std::max({kWireSize<Messages>...});

  std::uint32_t kind{};  // 1 for the first type of the variant, 2 for the next
  std::uint32_t reserved{};
  std::array<std::uint8_t, kSize> body{};
  ARMATURE_MEMBERS(Slot, kind, reserved, body)
};

template <class... Messages>
[[nodiscard]] Slot<std::variant<Messages...>> encode(const std::variant<Messages...>& message) noexcept {
  Slot<std::variant<Messages...>> slot;
  slot.kind = static_cast<std::uint32_t>(message.index()) + 1;
  // std::visit is not used: its tables of pointers would need an exception for a variant without a value.
  const auto put_if = [&]<class Message>(const Message* it) {
    if (it != nullptr) put(slot.body.data(), 0, *it);
  };
  (put_if(std::get_if<Messages>(&message)), ...);
  return slot;
}

// Nothing for an unknown kind, and for bytes that are no value of its type.
template <class... Messages>
[[nodiscard]] std::optional<std::variant<Messages...>> decode(const Slot<std::variant<Messages...>>& slot) noexcept {
  std::optional<std::variant<Messages...>> message;
  std::uint32_t kind = 0;
  const auto take_if = [&]<class Message>(std::type_identity<Message>) {
    if (slot.kind != ++kind) return;
    std::size_t at = 0;
    Message it{};
    if (take(slot.body.data(), at, it)) message.emplace(it);
  };
  (take_if(std::type_identity<Messages>{}), ...);
  return message;
}

}  // namespace armature::host_memory
