#include "cosim/cpu/fiber.hpp"

#include <array>
#include <boost/context/protected_fixedsize_stack.hpp>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
#define ARMATURE_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ARMATURE_ASAN 1
#endif
#endif
#ifdef ARMATURE_ASAN
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif

namespace armature::cosim {
namespace {

// `fake` null: the stack that is left never runs again.
void announce_switch([[maybe_unused]] void** fake, [[maybe_unused]] const void* bottom,
                     [[maybe_unused]] std::size_t bytes) {
#ifdef ARMATURE_ASAN
  __sanitizer_start_switch_fiber(fake, bottom, bytes);
#endif
}

void announce_arrival([[maybe_unused]] void* fake, [[maybe_unused]] const void** from_bottom,
                      [[maybe_unused]] std::size_t* from_bytes) {
#ifdef ARMATURE_ASAN
  __sanitizer_finish_switch_fiber(fake, from_bottom, from_bytes);
#endif
}

// Frames that never return leave their red zones marked in the shadow memory. These are the frames of the last switch
// and all frames of an abandoned fiber. Unmapping does not clear the marks. Memory that is mapped there next, often the
// stack of another fiber, would then cause false reports.
void announce_release([[maybe_unused]] const void* bottom, [[maybe_unused]] std::size_t bytes) {
#ifdef ARMATURE_ASAN
  __asan_unpoison_memory_region(bottom, bytes);
#endif
}

// Passes a stack that was allocated before to boost::context, so that its limits are known here.
struct PreallocatedStack {
  boost::context::protected_fixedsize_stack allocator;
  boost::context::stack_context context;
  boost::context::stack_context allocate() { return context; }
  void deallocate(boost::context::stack_context& stack) {
    announce_release(static_cast<const char*>(stack.sp) - stack.size, stack.size);
    allocator.deallocate(stack);
  }
};

}  // namespace

Fiber::Fiber(std::function<void()> entry, std::size_t stack_bytes) : entry_{std::move(entry)} {
  boost::context::protected_fixedsize_stack allocator{stack_bytes};
  boost::context::stack_context context = allocator.allocate();
  fiber_stack_.bottom = static_cast<const char*>(context.sp) - context.size;
  fiber_stack_.bytes = context.size;
  fiber_ = boost::context::fiber{std::allocator_arg, PreallocatedStack{allocator, context},
                                 [this](boost::context::fiber&& host) { return run(std::move(host)); }};
}

Fiber::~Fiber() {
  if (!finished_) abandon();
}

// The destructor of boost::context::fiber would throw an exception on the stack of the fiber, to unwind it. The
// controller's functions are noexcept, so that would end the program. Here the destructor never runs: the handle moves
// into storage that is never destroyed, and the stack is unmapped directly.
void Fiber::abandon() {
  alignas(boost::context::fiber) std::array<std::byte, sizeof(boost::context::fiber)> never_destroyed;
  new (never_destroyed.data()) boost::context::fiber{std::move(fiber_)};
  boost::context::stack_context stack;
  stack.size = fiber_stack_.bytes;
  stack.sp = const_cast<char*>(static_cast<const char*>(fiber_stack_.bottom)) + fiber_stack_.bytes;
  PreallocatedStack{boost::context::protected_fixedsize_stack{stack.size}, stack}.deallocate(stack);
}

boost::context::fiber Fiber::run(boost::context::fiber&& host) {
  host_ = std::move(host);
  announce_arrival(nullptr, &host_stack_.bottom, &host_stack_.bytes);
  entry_();
  finished_ = true;
  announce_switch(nullptr, host_stack_.bottom, host_stack_.bytes);
  return std::move(host_);
}

void Fiber::resume() {
  announce_switch(&host_stack_.fake, fiber_stack_.bottom, fiber_stack_.bytes);
  fiber_ = std::move(fiber_).resume();
  announce_arrival(host_stack_.fake, nullptr, nullptr);
}

void Fiber::suspend() {
  announce_switch(&fiber_stack_.fake, host_stack_.bottom, host_stack_.bytes);
  host_ = std::move(host_).resume();
  announce_arrival(fiber_stack_.fake, &host_stack_.bottom, &host_stack_.bytes);
}

}  // namespace armature::cosim
