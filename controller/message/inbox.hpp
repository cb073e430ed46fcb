// The commands that core 1 has received and not yet accepted: one inbox for each source.
#pragma once

#include <array>
#include <cstddef>

#include "controller/base/spsc_queue.hpp"
#include "controller/base/tag.hpp"
#include "controller/message/command.hpp"

namespace armature {

inline constexpr std::size_t kInboxCommands = 16;
using Inbox = SpscQueue<Command, kInboxCommands>;

// Element i is the inbox of Source i. The dispatcher empties them in this order.
using Inboxes = std::array<Inbox, kSources>;

[[nodiscard]] constexpr Inbox& inbox_of(Inboxes& inboxes, Source source) noexcept {
  return inboxes[static_cast<std::size_t>(source)];
}

}  // namespace armature
