// The commands that the pendant gives to the dispatcher, and the answer to the one whose result it must wait for.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "controller/base/tag.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/message/inbox.hpp"
#include "controller/pendant/parts/arm_view.hpp"
#include "controller/pendant/protocol/answer.hpp"

namespace armature::pendant {

class ArmCommands {
 public:
  // References must outlive the object.
  ArmCommands(Inbox& inbox, const ArmView& arm) noexcept : inbox_{inbox}, arm_{arm} {}

  // The answer when the inbox has no room. None: it was given, so an event may tell what becomes of it.
  [[nodiscard]] std::optional<Answer> give(Command command) noexcept;
  // True once when commands were given.
  [[nodiscard]] bool take_given() noexcept { return std::exchange(given_, false); }

  // An event will answer this command of the pendant; the commands that are given from now on are others.
  void await(Opcode opcode) noexcept { awaited_ = opcode; }
  // Nothing is awaited any more.
  void end_waiting() noexcept { awaited_.reset(); }
  [[nodiscard]] bool awaits(Tag tag) const noexcept { return awaited_ && tag == tag_; }
  [[nodiscard]] bool awaits_any() const noexcept { return awaited_.has_value(); }

  void on_event(const Event& event) noexcept;
  // The awaited command has this answer.
  void set_answer(const Answer& answer) noexcept { answer_ = answer; }
  [[nodiscard]] std::optional<Answer> take_answer() noexcept { return std::exchange(answer_, std::nullopt); }

 private:
  void on_start(Tag tag) noexcept;

  Inbox& inbox_;
  const ArmView& arm_;
  std::uint32_t count_ = 0;  // of commands since the start
  bool given_ = false;
  std::optional<Opcode> awaited_{};
  Tag tag_{Source::kPendant, 0};  // of the command that was given last before await(); 0: of none
  std::optional<Answer> answer_{};
};

}  // namespace armature::pendant
