// An incremental encoder on the motor shaft: A, B and Z levels whose edges fall on the right clock cycle.
//
// count = floor(position + 1/2). The levels over count mod 4 are, in the increasing direction of Vo 2021, Table 1:
//   0: a=0 b=0   1: a=1 b=0   2: a=1 b=1   3: a=0 b=1
// Z is high during one count per revolution, where count mod counts_per_rev is 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/base/units.hpp"
#include "cosim/plant/clock.hpp"
#include "cosim/plant/subcounts.hpp"

namespace armature::cosim {

struct CountRange {
  Counts min{};
  Counts max{};
};

class IncrementalEncoder {
 public:
  // Four counts per line; a positive multiple of 4, else std::invalid_argument. Starts at the position of `start`.
  explicit IncrementalEncoder(std::int32_t counts_per_rev, Counts start = {});

  // From cycle `from` on the shaft moves with constant speed, from where it is, to reach `target` at `from` + `length`,
  // and rests there. The previous motion must have ended.
  void move(Cycles from, Cycles length, Subcounts target);

  // The first cycle, after the last executed edge, at which the count changes; kNever while it does not change.
  [[nodiscard]] Cycles next_edge() const { return next_edge_; }

  // Executes the edge that is due at next_edge(). Throws std::logic_error when the following edge falls on the same
  // cycle: two lines cannot show a shaft that fast.
  void execute_edge();

  [[nodiscard]] Counts count() const { return count_; }
  [[nodiscard]] bool a() const { return ((count_.value() + 1) & 2) != 0; }
  [[nodiscard]] bool b() const { return (count_.value() & 2) != 0; }
  [[nodiscard]] bool z() const { return turn_ == 0; }

  // Shaft position at `now`, which is not before the present motion.
  [[nodiscard]] double position(Cycles now) const;  // [counts]

  // The smallest and the largest count that the lines showed from cycle `from` up to now. It covers at most the last
  // kHistory edges.
  [[nodiscard]] CountRange counts_since(Cycles from) const;

  static constexpr std::size_t kHistory = 64;

 private:
  struct Edge {
    Cycles cycle{-1};
    Counts before{};
  };

  [[nodiscard]] Cycles find_next_edge() const;

  std::int64_t counts_per_rev_;
  Cycles from_{};
  Cycles length_{1};
  Subcounts start_{};
  Subcounts target_{};
  Counts count_{};
  std::int64_t turn_ = 0;  // count modulo counts_per_rev
  Cycles next_edge_ = kNever;
  std::array<Edge, kHistory> history_{};  // ring
  std::size_t edges_ = 0;                 // executed in all
};

}  // namespace armature::cosim
