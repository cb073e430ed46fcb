// Runs ticks of pulses, motors and encoders as a whole where nothing asks for their edges (cosim/soc/motion_port.hpp).
//
// A run has the same bytes with it and without it. A tick is computed by its edges again from its start when something
// disturbs it: an access to a register that shows or changes what is left out, a fault, a waveform, a trigger at
// another time; and from the start on when more than pulses and lines may change in it: a switch, an output of a drive,
// a level that the decoders could take for a glitch.
#pragma once

#include <cstdint>
#include <optional>

#include "cosim/check/conservation.hpp"
#include "cosim/plant/plant.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

class WholeTicks {
 public:
  // References must outlive this object.
  WholeTicks(Soc& soc, Plant& plant, Conservation& conservation);

  // The next cycle at which advance() must be called, after on_trigger().
  [[nodiscard]] Cycles next_event() const { return next_event_; }
  // Begins a tick, or computes its edges because no trigger came at its end. `allowed`: ticks may be whole. Returns
  // whether pins of the encoders may have changed.
  bool advance(Cycles now, bool allowed);
  // The trigger pin has risen. To be called before anything else that looks at pins or plant. Returns as advance().
  bool on_trigger(Cycles now);

  // Whether the present tick is whole, and not over.
  [[nodiscard]] bool is_whole() const { return tick_ && !over_; }
  // Whether the access must see all edges.
  [[nodiscard]] bool disturbs(const BusRequest& request) const { return tick_ && port_->disturbs(request); }
  // Computes all edges up to `now`, from the start of the tick. Returns as advance().
  bool leave(Cycles now);

  [[nodiscard]] std::int64_t ticks() const { return ticks_; }  // that were whole

 private:
  bool begin(Cycles now);
  [[nodiscard]] bool expect_trigger();
  void continue_after(Cycles at, bool begun);

  Soc& soc_;
  MotionPort* port_;
  Plant& plant_;
  Conservation& conservation_;
  std::optional<TickPulses> tick_;  // that runs as a whole
  bool over_ = false;               // its trigger pin is high
  Cycles next_event_ = kNever;
  std::int64_t ticks_ = 0;
};

}  // namespace armature::cosim
