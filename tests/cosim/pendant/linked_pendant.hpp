// A pendant of a person on the simulated line, whose presses are a script.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/pendant/protocol/frame.hpp"
#include "cosim/pendant/operator_link.hpp"
#include "cosim/serial/serial_peer.hpp"

namespace armature::cosim::test {

class LinkedPendant final : public SerialPeer {
 public:
  // Switches the drives on: they are on at 60 ms.
  LinkedPendant() { at(20, pendant::Opcode::kServo, 1); }

  // In the order of time.
  void at(std::int64_t ms, std::function<void(OperatorLink&)> action) { script_.emplace_back(ms, std::move(action)); }
  void at(std::int64_t ms, pendant::Opcode opcode, std::uint8_t parameter = 0, std::int32_t payload = 0) {
    at(ms, [=](OperatorLink& line) { line.press({.opcode = opcode, .parameter = parameter, .payload = payload}); });
  }
  // Notes the state and the line at a time.
  void note_at(std::int64_t ms) {
    at(ms, [this](OperatorLink& line) {
      notes.push_back(
          {line.state(), pendant::kLineLine.of(line.page(pendant::Page::kLine)),
           std::string{pendant::kProgramNames.at(static_cast<std::size_t>(line.page(pendant::Page::kProgram)))}});
    });
  }

  void exchange(Cycles now, std::size_t room, std::vector<std::uint8_t>& in) override {
    const std::int64_t us = now.value() / (kClkFreqHz / 1'000'000);
    if (us < kStart_us) return;
    link.poll(OperatorLink::Time{us}, waiting_);
    while (!script_.empty() && script_.front().first * 1'000 <= us) {
      script_.front().second(link);
      script_.pop_front();
    }
    const std::size_t count = silent ? 0 : std::min(room, waiting_.size());
    in.insert(in.end(), waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
  }
  void send(std::uint8_t byte) override { link.receive({&byte, 1}); }

  [[nodiscard]] bool said(const std::string& text) const { return std::ranges::count(link.messages(), text) > 0; }

  struct Note {
    std::optional<pendant::State> state;
    std::int32_t line = 0;
    std::string program;
    friend bool operator==(const Note&, const Note&) = default;
  };
  OperatorLink link{1};
  std::vector<Note> notes;
  bool silent = false;

 private:
  static constexpr std::int64_t kStart_us = 2'000;  // the controller has configured the UART by then

  std::vector<std::uint8_t> waiting_;
  std::deque<std::pair<std::int64_t, std::function<void(OperatorLink&)>>> script_;
};

}  // namespace armature::cosim::test
