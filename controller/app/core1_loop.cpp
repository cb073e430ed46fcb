#include "controller/app/core1_loop.hpp"

#include <cassert>

namespace armature {

void Core1Loop::add(Core1Client& client) noexcept {
  assert(client_count_ < kMaxClients);
  clients_[client_count_++] = &client;
}

void Core1Loop::add(Interrupts line, InterruptHandler& handler) noexcept {
  assert(route_count_ < kMaxHandlers);
  routes_[route_count_++] = {.line = line, .handler = &handler};
}

void Core1Loop::run(RegisterBus& bus) noexcept {
  answer_watch();
  while (true) {
    const Interrupts lines = bus.wait_for_interrupt(Interrupts::kEvent | enabled_lines());
    if (lines == Interrupts::kNone) return;
    route(lines, bus);
    execute_clients(bus);
  }
}

Interrupts Core1Loop::enabled_lines() const noexcept {
  Interrupts lines = Interrupts::kNone;
  for (std::size_t i = 0; i < route_count_; ++i) {
    if (routes_[i].handler->enabled()) lines = lines | routes_[i].line;
  }
  return lines;
}

void Core1Loop::route(Interrupts lines, RegisterBus& bus) noexcept {
  for (std::size_t i = 0; i < route_count_; ++i) {
    if ((lines & routes_[i].line) != Interrupts::kNone) routes_[i].handler->on_interrupt(bus);
  }
}

void Core1Loop::execute_clients(RegisterBus& bus) noexcept {
  bool more = true;
  while (more) {
    answer_watch();
    for (const Event* event = channel_.events.front(); event != nullptr; event = channel_.events.front()) {
      notify_clients(*event);
      channel_.events.drop_front();
    }
    more = false;
    for (std::size_t i = 0; i < client_count_; ++i) more = clients_[i]->execute(bus) || more;
  }
  bool timed = false;
  for (std::size_t i = 0; i < client_count_; ++i) timed = timed || clients_[i]->waits_for_time();
  channel_.loop.wake_each_tick.store(timed, std::memory_order_relaxed);
}

void Core1Loop::on_event(const Event& event) noexcept {
  host_.on_event(event);
  notify_clients(event);
}

void Core1Loop::answer_watch() noexcept {
  channel_.loop.answered.store(channel_.loop.question.load(std::memory_order_relaxed), std::memory_order_relaxed);
}

void Core1Loop::notify_clients(const Event& event) noexcept {
  for (std::size_t i = 0; i < client_count_; ++i) clients_[i]->on_event(event);
}

}  // namespace armature
