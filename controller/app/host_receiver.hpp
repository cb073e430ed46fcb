// The client of core 1 that receives the commands of the host. It fills the inboxes before the dispatcher empties them.
#pragma once

#include "controller/command/core1_client.hpp"
#include "controller/command/inbox.hpp"
#include "controller/mailbox/controller_end.hpp"

namespace armature {

class HostReceiver final : public Core1Client {
 public:
  // References must outlive the receiver.
  HostReceiver(mailbox::Memory& memory, Inboxes& inboxes) noexcept : memory_{memory}, inboxes_{inboxes} {}

  // Core1Client
  [[nodiscard]] bool execute(RegisterBus&) noexcept override {
    mailbox::receive_commands(memory_, inboxes_);
    return false;
  }

 private:
  mailbox::Memory& memory_;
  Inboxes& inboxes_;
};

}  // namespace armature
