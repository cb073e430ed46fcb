// What a core asks of its simulation so that it may run ahead: it continues alone, without being suspended for each
// access and each computation, as long as nothing else can happen. Simulators call this temporal decoupling. A run has
// the same bytes with it and without it.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"
#include "cosim/bus/bus_access.hpp"
#include "cosim/bus/time_ahead.hpp"

namespace armature::cosim {

class RunAhead {
 public:
  virtual ~RunAhead() = default;

  // The cycle before which nothing but this core can happen, as the simulation and the chip stand now; the present
  // cycle or an earlier one if the core must not run ahead. The processor knows what its other core does.
  [[nodiscard]] virtual Cycles horizon() const = 0;
  // Lets time pass to `until` for a core that is at the present cycle. Returns the horizon there; `until` or an earlier
  // cycle: something happens, and the core must wait.
  virtual Cycles pass_time(Cycles until) = 0;
  // Whether the controller has written what the host must read in the cycle of the core.
  [[nodiscard]] virtual bool host_must_read() const = 0;
  // Brings the chip to `now`, the cycle of the core, which is before the horizon.
  virtual void catch_up(Cycles now) = 0;

  enum class Access : std::uint8_t {
    kRefused,  // it has not begun; the core must not run ahead with it
    kBegun,    // the core waits for Processor::complete()
    kDone,     // it has ended, and the chip is at its end
  };
  struct Outcome {
    Access access = Access::kRefused;
    std::uint32_t data = 0;  // of kDone
  };
  // Executes an access of core 0 that begins at time.now, as far as possible before the horizon; refuses it if
  // host_must_read(). kDone: `time` is that of its end.
  virtual Outcome try_access(const BusRequest& request, TimeAhead& time) = 0;
};

}  // namespace armature::cosim
