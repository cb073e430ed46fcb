// The faults of the lines of encoders and switches, between the plant and the chip, and of the serial line.
//
// Each fault changes what the lines show, in the order of their begins. What toggles does it on the cycle.
#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/logic/pins.hpp"
#include "cosim/plant/plant.hpp"
#include "cosim/time/never.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {

// A kind that LineFaults makes happen.
template <class Kind>
concept LineFault = std::same_as<Kind, EncoderStuck> || std::same_as<Kind, EncoderCable> ||
    std::same_as<Kind, EncoderSwapped> || std::same_as<Kind, EncoderChatter> || std::same_as<Kind, EncoderNoise> ||
    std::same_as<Kind, EncoderMiscount> || std::same_as<Kind, IndexSlip> || std::same_as<Kind, SwitchStuck> ||
    std::same_as<Kind, SwitchBounce> || std::same_as<Kind, UartBreak> || std::same_as<Kind, UartNoise>;

class LineFaults {
 public:
  // `plant` must outlive this object. `seed` is for the gaps of noise.
  LineFaults(const Plant& plant, std::uint64_t seed) : plant_{plant}, random_{seed} {}

  // The fault begins, or its time is over. For kinds of lines only.
  void begin(const FaultKind& kind, Cycles now);
  void end(const FaultKind& kind);

  // The next cycle at which advance() must be called and the pins be set anew.
  [[nodiscard]] Cycles next_event() const;
  void advance(Cycles now);

  void apply_to(SocInputs& pins) const;

  // The axes whose encoder has had a fault, one bit each: the decoder need not follow it any more.
  [[nodiscard]] std::uint8_t false_encoders() const { return false_encoders_; }

 private:
  struct Fault {
    FaultKind kind{};
    bool inverted = false;   // of what toggles
    std::int64_t added = 0;  // counts that the lines show too many
    Cycles next = kNever;
  };

  void toggle(Fault& fault, Cycles now);

  const Plant& plant_;
  Random random_;
  std::vector<Fault> faults_;
  std::uint8_t false_encoders_ = 0;
};

}  // namespace armature::cosim
