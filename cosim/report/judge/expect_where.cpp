#include "cosim/report/judge/expect_where.hpp"

#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::string seconds(Cycles at) {
  return fmt::format("{:.6f} s", to_seconds(at));
}

void add(std::string& text, const std::string& more) {
  text += (text.empty() ? "" : "; ") + more;
}

}  // namespace

ExpectWhere at_place(const std::optional<FactPlace>& place) {
  if (!place) return {};
  ExpectWhere where;
  where.at = place;
  where.text = fmt::format("tick {}, {}", place->tick, seconds(place->at));
  if (place->axis == 0) return where;
  where.axes.push_back(place->axis);
  where.text = fmt::format("axis {}, ", place->axis) + where.text;
  return where;
}

ExpectWhere first_at(const std::optional<FactPlace>& place) {
  ExpectWhere where = at_place(place);
  if (place) where.text = "the first: " + where.text;
  return where;
}

ExpectWhere at_faults(const RunFacts& facts) {
  ExpectWhere where;
  for (const FaultEvent& fault : facts.faults) {
    add(where.text,
        fmt::format("{}{}, {}", fault_name(fault.cause),
                    fault.axis == 0 ? std::string{} : fmt::format(" of axis {}", fault.axis), seconds(fault.at)));
    if (fault.axis != 0) where.axes.push_back(fault.axis);
  }
  return where;
}

ExpectWhere at_refusals(const RunFacts& facts) {
  ExpectWhere where;
  for (const RefusedMove& refused : facts.refusals) {
    add(where.text, fmt::format("move[{}], {}", refused.refusal.tag.number(), seconds(refused.at)));
  }
  return where;
}

std::string ExpectFailure::place() const {
  if (file.empty() && origin.override_text.empty()) return {};
  return place_text(file, origin);
}

std::string ExpectFailure::text() const {
  const std::string here = place();
  std::string all = here.empty() ? "" : here + ": ";
  all.append("expect.").append(key).append(": expected ").append(expected).append(", got ").append(got);
  if (!where.text.empty()) all.append(" (").append(where.text).append(")");
  return all;
}

}  // namespace armature::cosim
