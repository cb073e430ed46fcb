// What the protocol asks of the run that is debugged. The protocol (stub.hpp) knows nothing else of it.
//
// The run stops at positions. A position is the number of instructions that both cores have executed, in their order;
// it says the moment of the run exactly, because every run of a scenario is the same.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/iss/debug/protocol/registers.hpp"

namespace armature::cosim::iss {

// Where the run stops.
struct StopPoint {
  enum class Kind : std::uint8_t { kBreakpoint, kWrite, kRead, kAccess };
  Kind kind = Kind::kBreakpoint;
  std::uint32_t address = 0;
  std::uint32_t bytes = 4;  // of the others: that are watched

  friend bool operator==(const StopPoint&, const StopPoint&) = default;
};
inline constexpr std::size_t kMostStopPoints = 64;

struct Stop {
  enum class Why : std::uint8_t {
    kStep,       // a step has ended, or the run has begun
    kInterrupt,  // Target::interrupt()
    kPoint,      // at `point`
    kBeginning,  // the run cannot go back further
    kEnded,      // the run is over
    kFailed,     // the run cannot continue; the target has nothing more to say
  };
  Why why = Why::kStep;
  int core = 0;            // that is about to execute an instruction
  StopPoint point{};       // of kPoint
  std::uint32_t data = 0;  // of a watched StopPoint: the address that was accessed
  int exit_code = 0;       // of kEnded

  [[nodiscard]] bool is_last() const { return why == Why::kEnded || why == Why::kFailed; }
};

// How the run continues. The other core executes what is due in the meantime, and stops the run at a point, too. Back:
// to the latest stop before; at a watched access the run stands before it. What gdb has written is taken back, too.
struct Resume {
  enum class How : std::uint8_t { kContinue, kStep, kBack, kStepBack };
  How how = How::kContinue;
  int core = 0;                       // of a step
  std::uint32_t first = 0, last = 0;  // kStep goes on while the core is at first <= pc < last
};

class Target {
 public:
  virtual ~Target() = default;

  // ---- while the run stands. `core`: 0 or 1
  [[nodiscard]] virtual Registers registers(int core) = 0;
  // Returns false when the core is inside an access or in time that passes: its registers cannot be changed there.
  virtual bool write_register(int core, int number, std::uint64_t value) = 0;
  // As many bytes as there are from `address` on, at most `bytes`; nothing: the first one cannot be read. A register of
  // the logic is read as a word, as a core would read it; that has no effect on the run.
  [[nodiscard]] virtual std::vector<std::uint8_t> read_memory(std::uint32_t address, std::uint32_t bytes) = 0;
  // Returns false when there is no memory that may be written: not the code of the firmware, no register of the logic.
  virtual bool write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) = 0;
  // What the core does, for a list of threads.
  [[nodiscard]] virtual std::string state(int core) = 0;
  // The answer to a command of `monitor`, with ends of lines.
  [[nodiscard]] virtual std::string monitor(std::string_view command) = 0;
  // Continues the run, which stops at `points`. The stop is told later.
  virtual void resume(const Resume& how, std::span<const StopPoint> points) = 0;
  // Continues the run up to its end.
  virtual void detach() = 0;

  // ---- while the run continues: it stops soon, with kInterrupt or for a reason of its own
  virtual void interrupt() = 0;
};

}  // namespace armature::cosim::iss
