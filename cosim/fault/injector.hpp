// Makes the faults of a scenario happen. Nothing else knows where each kind acts.
#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

#include "cosim/cpu/processor.hpp"
#include "cosim/fault/active_faults.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/fault/line_faults.hpp"
#include "cosim/logic/pins.hpp"
#include "cosim/plant/plant.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

// The parts that faults act on, besides the pins. They must outlive the injector.
struct FaultTargets {
  Plant& plant;
  Processor& processor;
  Soc& soc;
};

// Kinds that act where somebody asks the injector.
template <class Kind>
concept AskedFor = std::same_as<Kind, Estop> || std::same_as<Kind, ClockStop> || std::same_as<Kind, InterruptLost> ||
    std::same_as<Kind, UartOverrun> || std::same_as<Kind, SlowSlave>;

class FaultInjector {
 public:
  // `seed` is for what is random in a fault.
  explicit FaultInjector(FaultTargets targets, std::uint64_t seed = 0)
      : targets_{targets}, lines_{targets.plant, seed} {}

  // The fault begins; the time of a fault with a duration is over. end() follows begin() of the same fault. After each
  // of them the pins of the chip must be set anew.
  void begin(const FaultKind& kind, Cycles now);
  void end(const FaultKind& kind, Cycles now);  // only for kinds with a duration

  // The next cycle at which advance() must be called. The pins of the chip must be set anew after it.
  [[nodiscard]] Cycles next_event() const { return lines_.next_event(); }
  void advance(Cycles now) { lines_.advance(now); }

  // Sets the pins that faults hold at a level, whatever else drives them. The others stay as they are.
  void apply_to(SocInputs& pins) const;

  // Whether no fault stops the clock of the logic.
  [[nodiscard]] bool clock_runs() const { return !active_.any<ClockStop>(); }

  // Whether no fault changes pulses or encoder lines within a tick, and no block of the motion and no encoder is as a
  // fault has left it.
  [[nodiscard]] bool leaves_ticks_alone() const {
    return !active_.any<Estop>() && clock_runs() && !motion_hangs_ && lines_.false_encoders() == 0;
  }
  // Whether no fault lasts that a core could notice by its accesses and interrupts.
  [[nodiscard]] bool leaves_cores_alone() const { return active_.empty() && errors_.empty(); }

  // The axes whose encoder has had a fault, one bit each: POSITION need not follow the motor any more.
  [[nodiscard]] std::uint8_t false_encoders() const { return lines_.false_encoders(); }

  // Whether a flop has flipped: the logic need not do what it should.
  [[nodiscard]] bool has_flipped_flops() const { return flops_flipped_; }

  // The interrupt levels of the chip as the processor sees them.
  [[nodiscard]] std::uint8_t seen_interrupts(std::uint8_t levels) const;

  // By how much a response that comes now is late.
  [[nodiscard]] Cycles response_delay() const;

  // Whether an access to this address that ends now is answered with SLVERR instead. Counts the answers.
  [[nodiscard]] bool takes_for_error(std::uint32_t address);

  // Whether a fault explains error responses of the bus to accesses of the program. Without such a fault they are an
  // error of the program.
  [[nodiscard]] bool explains_bus_errors() const { return blocks_hang_ || bus_errs_ || flops_flipped_; }

 private:
  // One start() for each kind, and one stop() for each kind with a duration. What a part asks for follows from the
  // faults that are active.
  void start(const PulseLoss& fault);
  void start(const SlowCore& fault);
  void start(const StrayWrite& fault);
  void start(const BlockHang& fault);
  void start(const ExtraPulses& fault);
  void start(const DriveAlarm& fault);
  void stop(const DriveAlarm& fault);
  void start(const AxisBlocked& fault);
  void stop(const AxisBlocked& fault);
  void start(const BrakeSlip& fault) { set_brake(fault.axis); }
  void stop(const BrakeSlip& fault) { set_brake(fault.axis); }
  void set_brake(int axis);
  void start(const CollisionTorque& fault) { set_push(fault.axis); }
  void stop(const CollisionTorque& fault) { set_push(fault.axis); }
  void set_push(int axis);
  void start(const CoreOneStuck& fault);
  void start(const SlaveError& fault);
  void start(const RegisterFlip& fault);
  void start(const FlopFlip& fault);
  void start(const MemoryFlip& fault);
  template <AskedFor Kind>
  void start(const Kind&) {}
  template <AskedFor Kind>
  void stop(const Kind&) {}
  template <LineFault Kind>
  void start(const Kind& fault) {
    lines_.begin(fault, now_);
  }
  template <LineFault Kind>
  void stop(const Kind& fault) {
    lines_.end(fault);
  }

  void follow_clock();

  FaultTargets targets_;
  LineFaults lines_;
  Cycles now_{};  // of begin() or end()
  ActiveFaults active_;
  bool blocks_hang_ = false, motion_hangs_ = false;
  std::vector<SlaveError> errors_;  // with the accesses that are left
  bool bus_errs_ = false;           // by SlaveError, or because a core may access anything
  bool flops_flipped_ = false;
  bool clock_ran_ = true;
};

}  // namespace armature::cosim
