#include "cosim/report/measure/demanded_stops.hpp"

namespace armature::cosim {

void DemandedStops::demand(const std::string& by, const RunPlace& where) {
  if (on_ && !open_) open_ = DemandedStop{.by = by, .where = where};
}

void DemandedStops::servo_enables(std::uint8_t levels, Cycles at) {
  if (!on_) last_row_.reset();
  on_ = levels != 0;
  if (!on_) close(at);
}

// The arm obeys nobody from the last trigger on. A trigger that comes nevertheless ends this demand, not others.
void DemandedStops::row(const RunPlace& trigger) {
  if (on_ && !missed_ && last_row_ && trigger.at - last_row_->at > longest_) {
    missed_ = DemandedStop{.by = "the missing ticks", .where = *last_row_, .executed = trigger.at};
  }
  last_row_ = trigger;
}

void DemandedStops::close(Cycles at) {
  if (open_ && !missed_ && at - open_->where.at > longest_) {
    missed_ = open_;
    missed_->executed = at;
  }
  if (!missed_ && last_row_ && at - last_row_->at > longest_) {
    missed_ = DemandedStop{.by = "the missing ticks", .where = *last_row_, .executed = at};
  }
  open_.reset();
  last_row_.reset();
}

std::optional<DemandedStop> DemandedStops::missed(Cycles now) const {
  if (missed_ || !on_) return missed_;
  if (open_ && now - open_->where.at > longest_) return open_;
  if (last_row_ && now - last_row_->at > longest_) {
    return DemandedStop{.by = "the missing ticks", .where = *last_row_};
  }
  return std::nullopt;
}

}  // namespace armature::cosim
