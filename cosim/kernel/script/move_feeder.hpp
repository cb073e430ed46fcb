// Gives the moves of the scenario to the controller. The points of a polyline, and the moves behind them, wait here
// while the controller has no room for them.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "controller/host_memory/host_side.hpp"
#include "cosim/scenario/moves/kinds.hpp"

namespace armature::cosim {

class MoveFeeder {
 public:
  // True when moves wait here. A queued move that comes meanwhile must wait, too.
  [[nodiscard]] bool busy() const { return !waiting_.empty(); }

  void add(const CommandSpec& move) { waiting_.push_back(move); }
  // Gives moves to the controller while it has room; true if it got any.
  bool feed(host_memory::HostSide& memory);
  // The controller refused a line of the move with this tag. The rest of a polyline is dropped.
  void on_refused(std::uint32_t tag);
  // Drops everything. Returns the tags of the moves of which the controller got nothing.
  [[nodiscard]] std::vector<std::uint32_t> drop_all();

 private:
  std::deque<CommandSpec> waiting_;
  std::size_t next_point_ = 0;  // of the first one, if it is a polyline
};

}  // namespace armature::cosim
