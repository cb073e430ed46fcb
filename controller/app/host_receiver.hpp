// The client of core 1 that receives the commands of the host. It fills the inboxes before the dispatcher empties them.
#pragma once

#include "controller/command/core1_client.hpp"
#include "controller/host_memory/controller_side.hpp"
#include "controller/message/inbox.hpp"

namespace armature {

class HostReceiver final : public Core1Client {
 public:
  // References must outlive the receiver.
  HostReceiver(host_memory::HostMemory& memory, Inboxes& inboxes) noexcept : memory_{memory}, inboxes_{inboxes} {}

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus&) noexcept override {
    host_memory::receive_commands(memory_, inboxes_);
    return false;
  }

 private:
  host_memory::HostMemory& memory_;
  Inboxes& inboxes_;
};

}  // namespace armature
