#include "controller/language/program/program_client.hpp"

#include <utility>
#include <variant>

#include "controller/core/overloaded.hpp"
#include "controller/core/timebase.hpp"

namespace armature {

void ProgramClient::set(Interpreter& program, Ticks begin) noexcept {
  program_ = &program;
  begin_ = begin;
  state_ = State::kPending;
}

void ProgramClient::resume() noexcept {
  if (state_ == State::kPaused) state_ = State::kRunning;
}

bool ProgramClient::execute(RegisterBus& bus) noexcept {
  bus_ = &bus;
  if (state_ == State::kPending && now() >= begin_) {
    program_->start();
    state_ = State::kRunning;
  }
  if (state_ != State::kRunning) return false;
  if (refused_) {
    // What was sent behind it must not be executed from a wrong place.
    if (!inbox_.try_push(Stop{.kind = Stop::Kind::kSoft})) return false;
    state_ = State::kFailed;
    return true;
  }
  switch (program_->step(*this)) {
    case Interpreter::Progress::kWorking:
      return true;
    case Interpreter::Progress::kWaiting:
      return false;
    case Interpreter::Progress::kPaused:
      state_ = State::kPaused;
      return false;
    case Interpreter::Progress::kEnded:
      state_ = State::kEnded;
      return false;
    case Interpreter::Progress::kAlarm:
      state_ = State::kFailed;
      return false;
  }
  return false;
}

bool ProgramClient::waits_for_time() const noexcept {
  return state_ == State::kPending || (state_ == State::kRunning && program_->waits_for_time());
}

void ProgramClient::on_event(const Event& event) noexcept {
  std::visit(
      Overloaded{[this](const MoveFinished& move) { settle(move.tag); }, [this](const IoDone& io) { settle(io.tag); },
                 [this](const MoveRefused& move) {
                   refused_ = refused_ || (under_way_ > 0 && move.tag.source() == Source::kProgram);
                   settle(move.tag);
                 },
                 [](const auto&) {}},
      event);
}

void ProgramClient::settle(Tag tag) noexcept {
  if (tag.source() == Source::kProgram && under_way_ > 0) --under_way_;
}

void ProgramClient::send(const Command& command, ProgramPlace place) noexcept {
  Command tagged = command;
  std::visit(
      [place](auto& one) {
        if constexpr (requires { one.tag; }) one.tag = Tag{Source::kProgram, place};
      },
      tagged);
  if (inbox_.try_push(tagged)) ++under_way_;
}

bool ProgramClient::done() const noexcept {
  return under_way_ == 0 && dispatcher_.rest().has_value();
}

JointAngles ProgramClient::joints() const noexcept {
  return dispatcher_.rest().value_or(JointAngles{});
}

bool ProgramClient::level(std::uint8_t pin, bool output) noexcept {
  return tool_.level(pin, output, *bus_);
}

void ProgramClient::set_now(std::uint8_t pin, bool level) noexcept {
  tool_.set({.pin = pin, .level = level}, *bus_);
}

Ticks ProgramClient::now() noexcept {
  return Ticks{bus_->now().value() / kTickCycles.value()};
}

void ProgramClient::note(const ProgramNote& note) noexcept {
  if (note.kind == ProgramNote::Kind::kLine) {
    line_ = note.place;
  } else {
    note_ = note;
  }
}

}  // namespace armature
