// Moves six shafts according to the demands of six drives. In an implementation the axes may act on each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/axes.hpp"
#include "cosim/logic/axis_bits.hpp"
#include "cosim/logic/axis_pairs.hpp"

namespace armature::cosim {

// The shaft of one motor. Its position is kept relative to the reference of its drive, where it is small: the sum of a
// far reference and a small error would lose the last bits of the error.
struct Shaft {
  double error = 0.0;  // position minus reference [counts]
  double speed = 0.0;  // [counts per step]

  [[nodiscard]] bool stands() const { return speed == 0.0; }  // with all that it moves
  // Exactly on the reference and standing.
  [[nodiscard]] bool at_rest() const { return error == 0.0 && speed == 0.0; }
};

// All shafts, so arranged that one instruction can move several.
struct Shafts {
  AxisNumbers error;
  AxisNumbers speed;

  [[nodiscard]] Shaft operator[](std::size_t axis) const { return {error[axis], speed[axis]}; }
  void set(std::size_t axis, const Shaft& shaft) {
    error[axis] = shaft.error;
    speed[axis] = shaft.speed;
  }
};

// Demand of a drive to its motor for one step. The reference is constant during the step.
struct MotorDemand {
  bool controlled = false;  // to the reference; false: the windings are shorted, a brake
  double reference = 0.0;   // [counts] from joint angle 0; Shaft::error is measured from here
};

// Of all drives.
struct MotorDemands {
  std::uint8_t controlled = 0;  // one bit per axis
  AxisNumbers reference;

  void set(std::size_t axis, const MotorDemand& demand) {
    set_bit(controlled, axis, demand.controlled);
    reference[axis] = demand.reference;
  }
};

class PositionLoops;

class Mechanics {
 public:
  virtual ~Mechanics() = default;

  // Moves the shafts by one step (kPlantStep). `axes`: those that need it, one bit each, axis 1 is bit 0; the others
  // rest and their drives have no new demand. Returns the axes whose shafts it has stepped: at least `axes`.
  virtual std::uint8_t step(std::uint8_t axes, const MotorDemands& demands, Shafts& shafts) = 0;

  // The position loops, if the axes do not act on each other and step() does nothing but step their shafts by them;
  // null: it does more.
  [[nodiscard]] virtual const PositionLoops* loops() const { return nullptr; }

  // Fault script: the shaft of this motor cannot turn while `on`. It stands at once.
  virtual void block(std::size_t axis, bool on) = 0;

  // Fault script: the holding brake of this motor has this share of its torque, 0..1. Returns false if it has none.
  virtual bool weaken_brake(std::size_t /*axis*/, double /*share*/) { return false; }

  // Fault script: this torque acts on the joint, behind its gear [N m]. Returns false if it has no gear.
  virtual bool push(std::size_t /*axis*/, double /*torque_nm*/) { return false; }

  // Controlled drives whose overload alarm has tripped in a step, one bit each. Their bits stay until they are not
  // controlled any more.
  [[nodiscard]] virtual std::uint8_t overloaded() const { return 0; }

  // For mechanics with a state of their own: keep() marks this moment, take_back() returns to it.
  virtual void keep() {}
  virtual void take_back() {}

  // The angle of each joint less that of its motor through the gear [deg]; none: the gears are rigid.
  [[nodiscard]] virtual std::optional<PerAxis<double>> load_lead_deg() const { return std::nullopt; }
};

}  // namespace armature::cosim
