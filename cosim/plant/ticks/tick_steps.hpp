// The steps of the motors in a whole tick, for all axes at once. The same arithmetic in the same order as step by step
// and pulse by pulse, so the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/logic/axis_pairs.hpp"
#include "cosim/logic/whole_tick.hpp"
#include "cosim/plant/electronic_gear.hpp"
#include "cosim/plant/mechanics.hpp"
#include "cosim/plant/servo_drive.hpp"
#include "cosim/plant/subcounts.hpp"
#include "cosim/plant/ticks/tick_rises.hpp"

namespace armature::cosim {

class TickSteps {
 public:
  static constexpr std::size_t kMaxSteps = 16;  // steps of a tick

  // Takes the pulses of the tick, which has at most kMaxSteps steps, and moves the shafts through the steps that begin
  // in it. `moving`: axes that need the next step. Pulses after the last step belong to the first one of the next tick.
  void run(const TickPulses& tick, std::span<const ServoDrive> drives, std::uint8_t moving, Mechanics& mechanics,
           Shafts& shafts);

  // The steps that were made: while everything rests none is needed.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint8_t moved() const { return moved_; }  // axes that took part, one bit each
  [[nodiscard]] Cycles began(std::size_t step) const { return began_[step]; }
  // Of the motor at the end of the step.
  [[nodiscard]] Subcounts position(std::size_t step, std::size_t axis) const { return positions_[axis][step + 1]; }
  // The same for all steps, after where the motor was before the first one, `begin`: one more than size().
  [[nodiscard]] std::span<const Subcounts> positions_from(Subcounts begin, std::size_t axis) {
    positions_[axis][0] = begin;
    return {positions_[axis].data(), size_ + 1};
  }
  // Of all steps: the magnitudes of the errors after them, and the way that the shaft moved in them.
  struct Extremes {
    static constexpr double kFar = std::numeric_limits<double>::max();
    struct OfPair {
      Pair smallest_error{kFar, kFar}, largest_error{};
      Pair least_way{kFar, kFar}, most_way{-kFar, -kFar};

      // A step that began with the error `before`.
      void add(Pair before, Pair error) {
        const Pair size = magnitude(error), way = error - before;
        smallest_error = smaller(smallest_error, size);
        largest_error = larger(largest_error, size);
        least_way = smaller(least_way, way);
        most_way = larger(most_way, way);
      }
    };

    AxisNumbers smallest_error, largest_error;  // [counts]
    AxisNumbers least_way, most_way;            // [counts], signed

    Extremes() {
      for (std::size_t i = 0; i < kAxisPairs; ++i) set(i, {});
    }
    [[nodiscard]] OfPair pair(std::size_t i) const {
      return {smallest_error.pair(i), largest_error.pair(i), least_way.pair(i), most_way.pair(i)};
    }
    void set(std::size_t i, const OfPair& of_pair) {
      smallest_error.set_pair(i, of_pair.smallest_error);
      largest_error.set_pair(i, of_pair.largest_error);
      least_way.set_pair(i, of_pair.least_way);
      most_way.set_pair(i, of_pair.most_way);
    }
  };
  [[nodiscard]] const Extremes& extremes() const { return extremes_; }

 private:
  void begin(const TickPulses& tick, std::span<const ServoDrive> drives);
  // All steps, two axes after the other two. Returns false, and moves no shaft, where that may give other bits: if a
  // limit acts, if all axes may rest, and where pulses must be taken one by one.
  bool step_apart(Cycles ends, const PositionLoops& loops, Shafts& shafts);
  WholePair step_pair(std::size_t i, Cycles ends, const PositionLoops& loops, Shafts& shafts, bool& exact);
  // Step by step, all axes together.
  void step_together(Cycles ends, std::uint8_t axes, bool moves, Mechanics& mechanics,
                     std::span<const ServoDrive> drives, Shafts& shafts);
  bool take_until(Cycles at, std::span<const ServoDrive> drives, Shafts& shafts);
  [[nodiscard]] ElectronicGear gear_after(const ServoDrive& drive, std::size_t axis, double taken) const;
  void make_step(Cycles now, std::uint8_t axes, Mechanics& mechanics, std::span<const ServoDrive> drives,
                 Shafts& shafts);
  void set_positions(std::size_t step, std::size_t i, WholePair subcounts) {
    positions_[2 * i][step + 1] = Subcounts{subcounts[0]};
    positions_[2 * i + 1][step + 1] = Subcounts{subcounts[1]};
  }
  [[nodiscard]] WholePair near_positions(std::size_t i, Pair error, Pair taken) const;
  [[nodiscard]] WholePair positions(std::size_t i, Pair error, Pair taken, std::span<const ServoDrive> drives) const;
  [[nodiscard]] bool are_moving(const Shafts& shafts);

  Cycles begins_{};  // the tick
  TickRises rises_;
  AxisNumbers taken_;        // pulses, without the sign
  AxisIntegers begin_;       // references at the start of the tick [subcounts], of plain gears
  bool plain_gears_ = true;  // a pulse is a count

  MotorDemands demands_;
  std::array<Cycles, kMaxSteps> began_{};
  PerAxis<std::array<Subcounts, kMaxSteps + 1>> positions_{};
  std::size_t size_ = 0;
  std::uint8_t moved_ = 0;
  std::size_t mover_ = 0;  // an axis that was moving
  Extremes extremes_;
};

}  // namespace armature::cosim
