// A bounded queue of slots in shared memory, between one producer and one consumer: no lock, no pointer, never blocks.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace armature::host_memory {

// `written` and `read` count slots and wrap at 2^32; number n is in slot n % kSlots. All slots can be used.
template <class T, std::uint32_t kSlots>
struct Ring {
  static_assert(std::has_single_bit(kSlots));
  static constexpr std::uint32_t kCapacity = kSlots;

  std::uint32_t written{};   // by the producer
  std::uint32_t read{};      // by the consumer
  std::uint32_t lost{};      // by the producer: those for which there was no room
  std::uint32_t reserved{};  // 0
  std::array<T, kSlots> slots{};

  // Producer. Returns false and changes nothing when the ring is full.
  [[nodiscard]] bool try_push(const T& value) noexcept {
    std::atomic_ref<std::uint32_t> tail{written};
    const std::uint32_t at = tail.load(std::memory_order_relaxed);
    if (at - std::atomic_ref<std::uint32_t>{read}.load(std::memory_order_acquire) == kSlots) return false;
    slots[at % kSlots] = value;
    tail.store(at + 1, std::memory_order_release);
    return true;
  }
  // Producer. What does not fit is counted as lost.
  void push_or_count_lost(const T& value) noexcept {
    if (try_push(value)) return;
    std::atomic_ref<std::uint32_t> count{lost};
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  [[nodiscard]] bool is_empty() const noexcept { return used() == 0; }
  [[nodiscard]] bool is_full() const noexcept { return used() == kSlots; }

  // Consumer. The oldest one, nothing when the ring is empty.
  [[nodiscard]] std::optional<T> try_pop() noexcept {
    std::atomic_ref<std::uint32_t> head{read};
    const std::uint32_t at = head.load(std::memory_order_relaxed);
    if (at == std::atomic_ref<std::uint32_t>{written}.load(std::memory_order_acquire)) return std::nullopt;
    std::optional<T> value{slots[at % kSlots]};
    head.store(at + 1, std::memory_order_release);
    return value;
  }

 private:
  [[nodiscard]] std::uint32_t used() const noexcept {
    return __atomic_load_n(&written, __ATOMIC_ACQUIRE) - __atomic_load_n(&read, __ATOMIC_ACQUIRE);
  }
};

}  // namespace armature::host_memory
