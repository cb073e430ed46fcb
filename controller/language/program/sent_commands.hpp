// The commands of a program that the dispatcher has got: how many are not over, where in the program the arm is, and
// what failed.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "controller/base/overloaded.hpp"
#include "controller/base/tag.hpp"
#include "controller/language/program/program_port.hpp"
#include "controller/message/event.hpp"

namespace armature {

class SentCommands {
 public:
  // The place of no command.
  void forget_place() noexcept { place_ = 0; }
  void forget_failure() noexcept { failed_.reset(); }

  void send(ProgramPlace place) noexcept {
    if (not_over_++ > 0) return;
    place_ = place;
    stopped_by_program_ = false;
  }
  // True: the program itself stops what it has sent, so that is no failure.
  void set_stopped(bool by_program) noexcept { stopped_by_program_ = by_program; }

  void on_event(const Event& event) noexcept {
    std::visit(Overloaded{[this](const MoveStarted& move) { start(move.tag); },
                          [this](const MoveFinished& move) {
                            end(move.tag, move.how == MoveFinished::How::kReachedEnd || stopped_by_program_);
                          },
                          [this](const IoDone& io) {
                            start(io.tag);
                            end(io.tag, true);
                          },
                          [this](const MoveRefused& move) { end(move.tag, stopped_by_program_); }, [](const auto&) {}},
               event);
  }

  [[nodiscard]] bool over() const noexcept { return not_over_ == 0; }
  // Of the command that started last, or of the first one if none of them has started.
  [[nodiscard]] ProgramPlace place() const noexcept { return place_; }
  // Of the first command that was not executed to its end.
  [[nodiscard]] const std::optional<ProgramPlace>& failed() const noexcept { return failed_; }

 private:
  void start(Tag tag) noexcept {
    if (tag.source() == Source::kProgram) place_ = tag.number();
  }
  void end(Tag tag, bool executed) noexcept {
    if (tag.source() != Source::kProgram || over()) return;
    --not_over_;
    if (!executed && !failed_) failed_ = tag.number();
  }

  std::uint32_t not_over_ = 0;
  ProgramPlace place_ = 0;
  std::optional<ProgramPlace> failed_;
  bool stopped_by_program_ = false;
};

}  // namespace armature
