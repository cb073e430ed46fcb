// What a ReversibleRun asks the process of its run, and the answer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/rewind/run_state.hpp"

namespace armature::cosim {

// Whether the process keeps the trace of the run, as long as it goes on.
enum class KeepTrace : bool { kNo, kYes };

struct RunRequest {
  enum class Kind : std::uint8_t {
    kGoTo,           // the cycle `to`, forwards or backwards, or the end of the run before it
    kFindTick,       // the row of tick `what`
    kFindCondition,  // the condition number `what` is met
    kFinish,         // the end of the run; the answer is followed by two texts, its summary and its trace
  };
  Kind kind = Kind::kGoTo;
  Cycles to{};            // of the others: the last cycle to look at
  std::int64_t what = 0;  // from 0
};

struct RunAnswer {
  RunState state;                 // kGoTo
  std::optional<Cycles> found{};  // of the others: in this cycle; none: not before the cycle `to` or the end
  std::array<char, 200> error{};  // '\0' ended; empty: none. The run cannot continue
};

}  // namespace armature::cosim
