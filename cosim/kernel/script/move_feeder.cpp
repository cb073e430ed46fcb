#include "cosim/kernel/script/move_feeder.hpp"

#include <utility>
#include <variant>

#include "cosim/scenario/to_controller.hpp"

namespace armature::cosim {

bool MoveFeeder::feed(host_memory::HostSide& memory) {
  bool any = false;
  while (!waiting_.empty()) {
    const CommandSpec& move = waiting_.front();
    const auto* polyline = std::get_if<PolylineSpec>(&move.kind);
    const Command command = polyline != nullptr ? to_command(*polyline, next_point_, move.index) : to_command(move);
    if (!memory.submit(Source::kProgram, command)) break;
    any = true;
    if (polyline != nullptr && ++next_point_ < polyline->points_mm.size()) continue;
    waiting_.pop_front();
    next_point_ = 0;
  }
  return any;
}

void MoveFeeder::on_refused(std::uint32_t tag) {
  if (waiting_.empty() || next_point_ == 0 || waiting_.front().index != tag) return;
  waiting_.pop_front();
  next_point_ = 0;
}

std::vector<std::uint32_t> MoveFeeder::drop_all() {
  std::vector<std::uint32_t> tags;
  if (std::exchange(next_point_, 0) > 0) waiting_.pop_front();
  for (const CommandSpec& move : waiting_) tags.push_back(move.index);
  waiting_.clear();
  return tags;
}

}  // namespace armature::cosim
