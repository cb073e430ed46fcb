// The main of core 1: waits for interrupts, routes each to its handler, and executes each client.
#pragma once

#include <array>
#include <cstddef>

#include "controller/activity/channel.hpp"
#include "controller/command/core1_client.hpp"
#include "controller/hal/interrupt_handler.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/message/event.hpp"

namespace armature {

class Core1Loop final : public EventListener {
 public:
  static constexpr std::size_t kMaxClients = 5;
  static constexpr std::size_t kMaxHandlers = 4;

  // `host` is notified of the events that core 1 causes. References must outlive the loop.
  Core1Loop(Channel& channel, EventListener& host) noexcept : channel_{channel}, host_{host} {}
  Core1Loop(const Core1Loop&) = delete;
  Core1Loop& operator=(const Core1Loop&) = delete;

  // Call before run(). Clients execute in the order in which they were added.
  void add(Core1Client& client) noexcept;
  void add(Interrupts line, InterruptHandler& handler) noexcept;

  // Returns only when wait_for_interrupt() returns kNone.
  void run(RegisterBus& bus) noexcept;

  // An event of core 1: notifies the host and all clients.
  void on_event(const Event& event) noexcept override;

 private:
  struct Route {
    Interrupts line = Interrupts::kNone;
    InterruptHandler* handler = nullptr;
  };

  [[nodiscard]] Interrupts enabled_lines() const noexcept;
  void route(Interrupts lines, RegisterBus& bus) noexcept;
  void execute_clients(RegisterBus& bus) noexcept;
  void notify_clients(const Event& event) noexcept;
  void answer_watch() noexcept;

  Channel& channel_;
  EventListener& host_;
  std::array<Core1Client*, kMaxClients> clients_{};
  std::array<Route, kMaxHandlers> routes_{};
  std::size_t client_count_ = 0;
  std::size_t route_count_ = 0;
};

}  // namespace armature
