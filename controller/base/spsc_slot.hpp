// Room for one large element between one producer and one consumer, each on its own core: no lock, no heap, never
// blocks. Both use the element in place.
#pragma once

#include <atomic>

namespace armature {

// T is default-constructible. One core calls full(), free_slot() and push_slot(), one other core the rest.
template <class T>
class SpscSlot {
 public:
  SpscSlot() = default;
  SpscSlot(const SpscSlot&) = delete;
  SpscSlot& operator=(const SpscSlot&) = delete;

  // Producer. The consumer may make room at any time.
  [[nodiscard]] bool full() const noexcept { return full_.load(std::memory_order_acquire); }
  // Producer, while there is room: the element to fill, which push_slot() then sends.
  [[nodiscard]] T& free_slot() noexcept { return element_; }
  void push_slot() noexcept { full_.store(true, std::memory_order_release); }

  // Consumer. Returns the element, which stays until drop_front(), or null.
  [[nodiscard]] const T* front() const noexcept { return full_.load(std::memory_order_acquire) ? &element_ : nullptr; }
  // Consumer, while there is an element. The producer may fill its place again from then on.
  void drop_front() noexcept { full_.store(false, std::memory_order_release); }

 private:
  T element_{};
  std::atomic<bool> full_{false};
};

}  // namespace armature
