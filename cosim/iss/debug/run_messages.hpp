// What the protocol and the process of the run tell each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cosim/iss/debug/protocol/registers.hpp"
#include "cosim/iss/debug/protocol/target.hpp"

namespace armature::cosim::iss {

inline constexpr std::size_t kMessageBytes = 4096;

// How the run shall continue, with all that decides where it stops: so a run that was taken back needs to know no more.
struct Continuation {
  Resume how;
  std::array<StopPoint, kMostStopPoints> points{};
  std::size_t count = 0;
};

struct DebugRequest {
  enum class Kind : std::uint8_t {
    kRegisters,      // of `core`
    kWriteRegister,  // `number` of `core` becomes `value`
    kRead,           // `size` bytes of memory at `address`
    kWrite,          // `bytes` to memory at `address`
    kState,          // of `core`, as text
    kMonitor,        // the command in `bytes`
    kResume,         // as `go_on` says
    kInterrupt,      // of a run that continues
    kDetach,         // to the end of the run
    kGoBack,         // to `position`, which is told as `stop`; the run stands somewhere behind it
    kSearchBack,     // the latest stop of `go_on` from a return point not behind `from` on, before `position`
  };
  Kind kind = Kind::kRegisters;
  int core = 0;
  int number = 0;
  std::uint64_t value = 0;
  std::uint32_t address = 0;
  std::uint32_t size = 0;  // of `bytes`, or to read
  std::array<std::uint8_t, kMessageBytes> bytes{};
  Continuation go_on{};
  std::int64_t position = 0, from = 0;
  Stop stop{};
};

struct DebugAnswer {
  enum class Kind : std::uint8_t {
    kAnswer,   // to a request while the run stands
    kText,     // `bytes` are a part of the text that the end of the run prints; then kStopped follows
    kStopped,  // at `stop` and `position`
    kFound,    // by kSearchBack: `stop` at `position` if `done`; the search began at `from`
  };
  Kind kind = Kind::kAnswer;
  bool done = true;
  std::uint32_t size = 0;
  std::array<std::uint8_t, kMessageBytes> bytes{};
  Registers registers{};
  Stop stop{};
  std::int64_t position = 0, from = 0;
  std::array<std::int64_t, 2> before{};  // the positions before the latest instructions of both cores; -1: none
};

// With `text`, or as much of it as a message has room for.
[[nodiscard]] DebugAnswer text_answer(std::string_view text);

}  // namespace armature::cosim::iss
