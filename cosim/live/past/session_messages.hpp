// What a ReversibleSession asks the process of its session, and the answer.
#pragma once

#include <array>
#include <cstdint>

#include "controller/base/units.hpp"

namespace armature::cosim {

struct SessionRequest {
  enum class Kind : std::uint8_t {
    kAdvance,  // up to the cycle `to`
    kTell,     // a message of the page, which follows as a text. It is counted
    kAsk,      // the same, but it changes nothing and is not counted
    kLeave,    // nobody is at the page. It is counted
    kState,    // for the page
    kGoBack,   // to a return point that is not behind the cycle `to`, which is where the way goes
    kFinish,   // the end of the run
  };
  Kind kind = Kind::kAdvance;
  Cycles to{};
  bool on_the_way = false;  // kAdvance: to the cycle of the last kGoBack
  double factor = 0;        // kState: simulated time per real time
};

// Followed by three texts: what was asked for, and what serial.csv and log.txt have beyond `written`.
struct SessionAnswer {
  Cycles now{};
  bool over = false;
  std::int64_t told = 0;                  // requests that were counted so far
  std::array<std::int64_t, 2> written{};  // bytes of serial.csv and log.txt that belong to the past of this session
  std::array<char, 200> error{};          // '\0' ended; empty: none. The session cannot continue, and no text follows
};

}  // namespace armature::cosim
