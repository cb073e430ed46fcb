// An incremental encoder on the motor shaft: A, B and Z levels whose edges fall on the right clock cycle.
//
// count = floor(position + 1/2). The levels over count mod 4 are, in the increasing direction of Vo 2021, Table 1:
//   0: a=0 b=0   1: a=1 b=0   2: a=1 b=1   3: a=0 b=1
// Z is high during one count per revolution, where count mod counts_per_rev is 0.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/plant/clock.hpp"
#include "cosim/plant/subcounts.hpp"

namespace armature::cosim {

class IncrementalEncoder {
 public:
  // Four counts per line; a positive multiple of 4, else std::invalid_argument. Starts at the position of `start`.
  explicit IncrementalEncoder(std::int32_t counts_per_rev, Counts start = {});

  // From cycle `from` on the shaft moves with constant speed, from where it is, to reach `target` at `from` + `length`,
  // and rests there. The previous motion must have ended.
  void move(Cycles from, Cycles length, Subcounts target);

  // ---- whole ticks: motions whose edges are not executed
  // As move(). count() stands still until resume().
  void move_without_edges(Cycles from, Cycles length, Subcounts target);
  // The count after the edges up to the cycle `at`, which is in this motion or in the one before it, or later.
  [[nodiscard]] Counts count_after(Cycles at) const {
    const Counts count = target_count();
    return at >= motions_.present.from && nearest_count(start()) == count ? count : count_on_the_way(at);
  }
  // The cycle of the latest edge up to `at` in the motions without edges; none: not known.
  [[nodiscard]] std::optional<Cycles> edge_before(Cycles at) const;
  // Executes the edges that are left out up to the cycle `at`.
  void resume(Cycles at);
  [[nodiscard]] Counts target_count() const { return nearest_count(target()); }
  [[nodiscard]] Subcounts target() const { return motions_.present.target; }
  [[nodiscard]] Subcounts start() const { return motions_.present.start; }
  // With constant speed. The position is start + (target - start) d / length, d cycles after `from`.
  struct Motion {
    Cycles from{};
    Cycles length{1};
    Subcounts start{};
    Subcounts target{};

    // The cycle at which the count changes, at this boundary on the way: the first one with position >= boundary if the
    // position rises, with position < boundary if it falls.
    [[nodiscard]] Cycles crosses(Subcounts boundary) const;
  };
  // What a tick changes.
  struct Motions {
    Motion present{}, before{};          // before: none unless it ended where the present one began
    Motion counted{}, counted_before{};  // the latest two in which the count changed
  };
  [[nodiscard]] const Motions& motions() const { return motions_; }
  [[nodiscard]] Motions& motions_to_change() { return motions_; }
  void set_motions(const Motions& motions) { motions_ = motions; }
  // The edges in the history after `from`, the latest one first: calls `use(cycle, count before it)`.
  template <class Use>
  void edges_since(Cycles from, Use use) const {
    for (std::size_t i = 1; i <= std::min(edges_, kHistory); ++i) {
      const Edge& edge = history_[(edges_ - i) % kHistory];
      if (edge.cycle <= from) return;
      use(edge.cycle, edge.before);
    }
  }
  [[nodiscard]] static constexpr bool a(Counts count) { return ((count.value() + 1) & 2) != 0; }
  [[nodiscard]] static constexpr bool b(Counts count) { return (count.value() & 2) != 0; }
  [[nodiscard]] bool z(Counts count) const { return count.value() % counts_per_rev_ == 0; }
  [[nodiscard]] std::int64_t counts_per_rev() const { return counts_per_rev_; }

  // The first cycle, after the last executed edge, at which the count changes; kNever while it does not change.
  [[nodiscard]] Cycles next_edge() const { return next_edge_; }

  // Executes the edge that is due at next_edge(). Throws std::logic_error when the following edge falls on the same
  // cycle: two lines cannot show a shaft that fast.
  void execute_edge();

  [[nodiscard]] Counts count() const { return count_; }
  [[nodiscard]] bool a() const { return a(count_); }
  [[nodiscard]] bool b() const { return b(count_); }
  [[nodiscard]] bool z() const { return z(count_); }

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

  [[nodiscard]] Counts count_on_the_way(Cycles at) const;
  void begin_motion(Cycles from, Cycles length, Subcounts target);
  [[nodiscard]] Cycles find_next_edge() const;

  std::int64_t counts_per_rev_;
  Motions motions_{};
  Counts count_{};
  Cycles next_edge_ = kNever;
  std::array<Edge, kHistory> history_{};  // ring
  std::size_t edges_ = 0;                 // executed in all
};

}  // namespace armature::cosim
