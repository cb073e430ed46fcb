// The controller's side of the mailbox memory.
#pragma once

#include <atomic>
#include <cstdint>

#include "controller/command/inbox.hpp"
#include "controller/event/event.hpp"
#include "controller/mailbox/memory.hpp"
#include "controller/motion/controller_observer.hpp"
#include "controller/motion/conveyor_config.hpp"

namespace armature::mailbox {

// Core 0 writes the telemetry and its events.
class Core0Writer final : public ControllerObserver {
 public:
  explicit Core0Writer(Memory& memory) noexcept : memory_{memory} {}
  void on_tick(const Telemetry& telemetry) noexcept override;
  void on_event(const Event& event) noexcept override;

 private:
  Memory& memory_;
};

// Core 1 writes its events.
class Core1Writer final : public EventListener {
 public:
  explicit Core1Writer(Memory& memory) noexcept : memory_{memory} {}
  void on_event(const Event& event) noexcept override;

 private:
  Memory& memory_;
};

// Core 0 reads the encoder of the conveyor, which the host publishes as a fieldbus master would.
class BeltReader final : public BeltEncoder {
 public:
  explicit BeltReader(Memory& memory) noexcept : memory_{memory} {}
  [[nodiscard]] std::int64_t counts() noexcept override {
    return std::atomic_ref<std::int64_t>{memory_.belt_counts}.load(std::memory_order_acquire);
  }

 private:
  Memory& memory_;
};

// Core 1 moves the commands of the host into the inboxes of their sources. A command that finds its inbox full, because
// the inbox was not emptied before, stays in its ring. Slots without a valid command are dropped.
void receive_commands(Memory& memory, Inboxes& inboxes) noexcept;

}  // namespace armature::mailbox
