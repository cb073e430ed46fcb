// A stackful coroutine: runs blocking code that can suspend itself in the middle of a call.
//
// One host thread; resume() and suspend() are plain calls. AddressSanitizer is informed of each switch, so sanitizer
// builds check the code inside fibers like other code.
#pragma once

#include <boost/context/fiber.hpp>
#include <cstddef>
#include <functional>

namespace armature::cosim {

class Fiber {
 public:
  // `entry` runs on its own stack when resume() is called for the first time.
  explicit Fiber(std::function<void()> entry, std::size_t stack_bytes = std::size_t{256} * 1024);
  // A fiber that has not finished is abandoned: its stack is freed and its code runs no more, not even destructors. So
  // objects that are on the stack during a suspend() must own nothing (no heap, no files, no locks).
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  // Host side: continues the entry function until it suspends or returns.
  void resume();

  // Fiber side: returns control to the caller of resume().
  void suspend();

  [[nodiscard]] bool finished() const { return finished_; }

 private:
  // Data of a stack that AddressSanitizer needs for a switch.
  struct Stack {
    void* fake = nullptr;
    const void* bottom = nullptr;
    std::size_t bytes = 0;
  };

  boost::context::fiber run(boost::context::fiber&& host);
  void abandon();

  std::function<void()> entry_;
  Stack fiber_stack_;
  Stack host_stack_;
  boost::context::fiber fiber_;
  boost::context::fiber host_;
  bool finished_ = false;
};

}  // namespace armature::cosim
