// The controller's side of the host memory.
#pragma once

#include <atomic>
#include <cstdint>

#include "controller/cell/conveyor_config.hpp"
#include "controller/host_memory/memory.hpp"
#include "controller/message/event.hpp"
#include "controller/message/inbox.hpp"
#include "controller/motion/controller_observer.hpp"

namespace armature::host_memory {

// Core 0 writes the telemetry and its events.
class Core0Writer final : public ControllerObserver {
 public:
  explicit Core0Writer(HostMemory& memory) noexcept : memory_{memory} {}
  void on_tick(const Telemetry& telemetry) noexcept override;
  void on_event(const Event& event) noexcept override;

 private:
  HostMemory& memory_;
};

// Core 1 writes its events.
class Core1Writer final : public EventListener {
 public:
  explicit Core1Writer(HostMemory& memory) noexcept : memory_{memory} {}
  void on_event(const Event& event) noexcept override;

 private:
  HostMemory& memory_;
};

// Core 0 reads the samples of the conveyor, which the host publishes as a fieldbus master would.
class BeltReader final : public BeltSensor {
 public:
  explicit BeltReader(HostMemory& memory) noexcept : memory_{memory} {}
  // A number that is new has its count, because the host writes the count first.
  [[nodiscard]] Sample latest() noexcept override {
    const std::uint32_t number = std::atomic_ref<std::uint32_t>{memory_.belt_sample}.load(std::memory_order_acquire);
    return {.counts = std::atomic_ref<std::int64_t>{memory_.belt_counts}.load(std::memory_order_relaxed),
            .number = number};
  }

 private:
  HostMemory& memory_;
};

// Core 1 moves the commands of the host into the inboxes of their sources. A command that finds its inbox full, because
// the inbox was not emptied before, stays in its ring. Slots without a valid command are dropped.
void receive_commands(HostMemory& memory, Inboxes& inboxes) noexcept;

}  // namespace armature::host_memory
