// A block of the model with its inputs. It computes the edges of the block that it must (block.hpp).
#pragma once

#include "cosim/model/block.hpp"

namespace armature::cosim::model {

// Inputs: the levels that Block::edge() takes, with operator==.
template <class Block, class Inputs>
class Slot {
 public:
  // The edge `at`. `in`: levels before it.
  Answer edge(Cycles at, const Inputs& in, const Strobes& access) {
    if (!access.any() && at < block_.wakes_at() && in == latest_) return {};
    latest_ = after_trigger(in);
    return block_.edge(at, access, in);
  }

  // Whether an output may change at an edge that must be computed for its access only.
  static constexpr bool kAccessShows = !requires(Block & block) { block.access(Cycles{}, Strobes{}, Inputs{}); };
  // Such an edge: wakes_at() is later, and the inputs are those of before.
  Answer access(Cycles at, const Strobes& access) {
    if constexpr (kAccessShows)
      return block_.edge(at, access, latest_);
    else
      return block_.access(at, access, latest_);
  }

  // The next edge that must be computed, after the edge `now`. `in`: the levels that it will see.
  [[nodiscard]] Cycles wakes_at(Cycles now, const Inputs& in) const {
    return in == latest_ ? block_.wakes_at() : now + Cycles{1};
  }

  // The gated clock of the block stands still: it continues what has the other clock, and has no access any more.
  void stop_gated_clock() { block_.stop_gated_clock(); }

  [[nodiscard]] const Block& block() const { return block_; }
  [[nodiscard]] Block& block() { return block_; }

 private:
  Block block_{};
  Inputs latest_{};
};

}  // namespace armature::cosim::model
