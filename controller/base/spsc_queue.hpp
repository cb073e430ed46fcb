// A bounded queue between one producer and one consumer, each on its own core: no lock, no heap, never blocks.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>

namespace armature {

// Holds up to `kCapacity` elements. T is default-constructible and copyable. One core calls what is marked with
// Producer, one other core the rest; one core may also call all of them.
template <class T, std::size_t kCapacity>
class SpscQueue {
  static_assert(kCapacity > 0);

 public:
  SpscQueue() = default;
  SpscQueue(const SpscQueue&) = delete;
  SpscQueue& operator=(const SpscQueue&) = delete;

  // Producer. Returns false and changes nothing when the queue is full.
  [[nodiscard]] bool try_push(const T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    const std::size_t next = after(tail);
    if (next == head_.load(std::memory_order_acquire)) return false;
    slots_[tail] = value;
    tail_.store(next, std::memory_order_release);
    return true;
  }

  // Producer, for large elements: the slot to fill, which push_slot() then adds while there is room. It may be filled
  // even while the queue is full.
  [[nodiscard]] T& free_slot() noexcept { return slots_[tail_.load(std::memory_order_relaxed)]; }
  void push_slot() noexcept { tail_.store(after(tail_.load(std::memory_order_relaxed)), std::memory_order_release); }

  // Producer. True when `count` elements can be added now; the consumer may make room at any time.
  [[nodiscard]] bool has_room(std::size_t count) const noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed), head = head_.load(std::memory_order_acquire);
    return (head + kSlots - 1 - tail) % kSlots >= count;
  }

  // Producer. True when try_push would fail now; the consumer may make room at any time.
  [[nodiscard]] bool full() const noexcept {
    return after(tail_.load(std::memory_order_relaxed)) == head_.load(std::memory_order_acquire);
  }

  // Consumer. The oldest element, nothing when the queue is empty.
  [[nodiscard]] std::optional<T> try_pop() noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_.load(std::memory_order_acquire)) return std::nullopt;
    std::optional<T> value{slots_[head]};
    head_.store(after(head), std::memory_order_release);
    return value;
  }

  // Consumer. Returns the oldest element, which stays in the queue, or null when the queue is empty. For large elements
  // and for those that may have to wait; drop_front() removes it.
  [[nodiscard]] const T* front() const noexcept {
    return empty() ? nullptr : &slots_[head_.load(std::memory_order_relaxed)];
  }

  // Consumer. The element that follows `index` others, or null.
  [[nodiscard]] const T* peek(std::size_t index) const noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed), tail = tail_.load(std::memory_order_acquire);
    return index < (tail + kSlots - head) % kSlots ? &slots_[(head + index) % kSlots] : nullptr;
  }

  // Consumer, while the queue is not empty.
  void drop_front() noexcept { head_.store(after(head_.load(std::memory_order_relaxed)), std::memory_order_release); }

  // Consumer. Drops every element that is in the queue now.
  void clear() noexcept { head_.store(tail_.load(std::memory_order_acquire), std::memory_order_release); }

  // Consumer.
  [[nodiscard]] bool empty() const noexcept {
    return head_.load(std::memory_order_relaxed) == tail_.load(std::memory_order_acquire);
  }

 private:
  // One slot always stays free, so equal indices mean empty.
  static constexpr std::size_t kSlots = kCapacity + 1;
  static constexpr std::size_t after(std::size_t index) noexcept { return index + 1 == kSlots ? 0 : index + 1; }

  std::array<T, kSlots> slots_{};
  std::atomic<std::size_t> head_{0};  // next to pop, written by the consumer only
  std::atomic<std::size_t> tail_{0};  // next to fill, written by the producer only
};

}  // namespace armature
