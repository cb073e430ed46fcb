// Makes the faults of a scenario happen. Nothing else knows where each kind acts.
#pragma once

#include "cosim/cpu/processor.hpp"
#include "cosim/fault/fault_spec.hpp"
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

class FaultInjector {
 public:
  explicit FaultInjector(FaultTargets targets) : targets_{targets} {}

  // The fault begins; the time of a fault with a duration is over. end() follows begin() of the same fault. After each
  // of them the pins of the chip must be set anew.
  void begin(const FaultKind& kind);
  void end(const FaultKind& kind);  // only for kinds with a duration

  // Sets the pins that faults hold at a level, whatever else drives them. The others stay as they are.
  void apply_to(SocInputs& pins) const;

  // Whether no fault stops the clock of the logic.
  [[nodiscard]] bool clock_runs() const { return clock_stops_ == 0; }

  // Whether no fault holds a pin or stops a clock.
  [[nodiscard]] bool is_quiet() const { return estops_ == 0 && clock_stops_ == 0 && !blocks_hang_; }

  // Whether a fault explains error responses of the bus to accesses of the program. Without such a fault they are an
  // error of the program.
  [[nodiscard]] bool explains_bus_errors() const { return blocks_hang_; }

 private:
  // One start() for each kind, and one stop() for each kind with a duration.
  void start(const PulseLoss& fault);
  void start(const SlowCore& fault);
  void start(const Estop& fault);
  void stop(const Estop& fault);
  void start(const ClockStop& fault);
  void stop(const ClockStop& fault);
  void start(const StrayWrite& fault);
  void start(const BlockHang& fault);

  FaultTargets targets_;
  int estops_ = 0;       // emergency stops that hold the pin low
  int clock_stops_ = 0;  // faults that stop the clock
  bool blocks_hang_ = false;
};

}  // namespace armature::cosim
