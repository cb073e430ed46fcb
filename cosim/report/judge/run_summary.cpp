#include "cosim/report/judge/run_summary.hpp"

#include "cosim/time/clock.hpp"

namespace armature::cosim {

double RunSummary::simulated_s() const {
  return to_seconds(cycles);
}
double RunSummary::cycles_per_s() const {
  return host.wall_s > 0 ? static_cast<double>(cycles.value()) / host.wall_s : 0;
}
double RunSummary::real_time_factor() const {
  return host.wall_s > 0 ? simulated_s() / host.wall_s : 0;
}

}  // namespace armature::cosim
