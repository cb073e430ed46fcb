// Stops that something demanded, and whether they were executed: all servo enables must be low soon after.
//
// Demanded by: the emergency stop, a fault that the controller reports, an error response that stops core 0, and ticks
// that do not come. The longest time is that of the watchdog and the drop-out, with much room.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "cosim/report/measure/run_place.hpp"

namespace armature::cosim {

struct DemandedStop {
  std::string by;  // `estop`, `core 0 stopped`
  RunPlace where{};
  std::optional<Cycles> executed{};  // none: not yet
};

class DemandedStops {
 public:
  // 1 ms: the watchdog needs five ticks.
  static constexpr Cycles kLongest{20 * armature::kTickCycles.value()};

  // The drop-out of the scenario needs this time, if it has one.
  void set_drop_out(Cycles time) { longest_ = std::max(longest_, time + armature::kTickCycles); }

  void demand(const std::string& by, const RunPlace& where);
  void servo_enables(std::uint8_t levels, Cycles at);
  void row(const RunPlace& trigger);

  // The first stop that was demanded and not executed in time, as far as is known at `now`; none: all were.
  [[nodiscard]] std::optional<DemandedStop> missed(Cycles now) const;

 private:
  void close(Cycles at);

  Cycles longest_ = kLongest;
  bool on_ = false;                   // a servo enable is high
  std::optional<DemandedStop> open_;  // while servo enables are high
  std::optional<DemandedStop> missed_;
  std::optional<RunPlace> last_row_;
};

}  // namespace armature::cosim
