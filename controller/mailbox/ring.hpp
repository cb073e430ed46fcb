// A bounded queue of blocks in shared memory, between one producer and one consumer: no lock, no pointer, never blocks.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <optional>

#include "controller/mailbox/block.hpp"

namespace armature::mailbox {

// `written` and `read` count blocks and wrap at 2^32; block n is in slot n % kSlots. All slots can be used.
template <class Block, u32 kSlots>
struct Ring {
  static_assert(std::has_single_bit(kSlots));
  static constexpr u32 kCapacity = kSlots;

  u32 written{};   // by the producer
  u32 read{};      // by the consumer
  u32 lost{};      // by the producer: blocks for which there was no room
  u32 reserved{};  // 0
  std::array<Block, kSlots> slots{};

  // Producer. Returns false and changes nothing when the ring is full.
  [[nodiscard]] bool try_push(const Block& block) noexcept {
    std::atomic_ref<u32> tail{written};
    const u32 at = tail.load(std::memory_order_relaxed);
    if (at - std::atomic_ref<u32>{read}.load(std::memory_order_acquire) == kSlots) return false;
    slots[at % kSlots] = block;
    tail.store(at + 1, std::memory_order_release);
    return true;
  }
  // Producer. A block that does not fit is counted as lost.
  void push_or_count_lost(const Block& block) noexcept {
    if (try_push(block)) return;
    std::atomic_ref<u32> count{lost};
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  // Consumer. The oldest block, nothing when the ring is empty.
  [[nodiscard]] std::optional<Block> try_pop() noexcept {
    std::atomic_ref<u32> head{read};
    const u32 at = head.load(std::memory_order_relaxed);
    if (at == std::atomic_ref<u32>{written}.load(std::memory_order_acquire)) return std::nullopt;
    std::optional<Block> block{slots[at % kSlots]};
    head.store(at + 1, std::memory_order_release);
    return block;
  }
};

}  // namespace armature::mailbox
