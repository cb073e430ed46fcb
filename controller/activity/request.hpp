// A request of core 1 to core 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "controller/activity/activity_id.hpp"

namespace armature {

// Built and read in its place in the queue.
struct Request {
  enum class Kind : std::uint8_t {
    kBegin,       // `to` gets the arm, which stands; a further one is for the present motion or for the next one
    kFeed,        // more for `to`
    kStop,        // the arm is brought to rest, as `stop` says
    kSwitchOff,   // sent only when the arm stands: enter Fault with the cause kDrivesOff
    kClearFault,  // leave Fault; answered by kRest, or by kFaultPersists when the cause persists. Sent only in Fault
  };
  static constexpr std::size_t kBody = 256;

  Kind kind = Kind::kFeed;
  ActivityId to = ActivityId::kPlans;
  StopKind stop = StopKind::kQuick;
  std::uint32_t number = 0;  // of this one, or of the newest one that core 0 answers; wraps
  alignas(8) std::array<std::byte, kBody> body{};

  // What begins or feeds an activity: a type of that activity.
  template <class T>
  void set(const T& content) noexcept {
    static_assert(sizeof(T) <= kBody && alignof(T) <= 8 && std::is_trivially_destructible_v<T>);
    ::new (static_cast<void*>(body.data())) T(content);
  }
  template <class T>
  [[nodiscard]] const T& get() const noexcept {
    return *std::launder(static_cast<const T*>(static_cast<const void*>(body.data())));
  }
};

}  // namespace armature
