// A run that tests of the reports show.
#pragma once

#include <optional>
#include <string>

#include "cosim/report/judge/run_summary.hpp"

namespace armature::cosim::test {

inline RunSummary sample_summary() {
  RunSummary summary;
  summary.scenario = "late_core";
  summary.description = "d";
  summary.robot = "vo2021_6r";
  summary.facts.cycles = Cycles{25'000'000};
  summary.facts.bus_reads = 1000;
  summary.facts.bus_writes = 700;
  summary.facts.worst_tick = Cycles{625};
  summary.facts.sha256 = std::string(64, 'a');
  summary.host.wall_s = 2.0;
  RunFacts& facts = summary.facts;
  facts.ticks = 10'000;
  facts.worst_following_error_deg = {0.5, 0, 0, 0, 0, 0.9553};
  facts.faults.push_back({FaultCause::kFollowingError, {.tick = 5'999, .at = Cycles{15'000'000}, .axis = 3}});
  facts.refusals.push_back({{.reason = Refusal::kOutsideLimits,
                             .axis = 2,
                             .path = {.at = 1, .angle_rad = 2.0943951023931953, .limit_rad = 1.9198621771937625}},
                            Cycles{500'000}});  // 120 and 110 deg
  facts.end_fault = FaultCause::kFollowingError;
  facts.moves.resize(3);
  facts.taken_ticks = {17, std::nullopt, 18};
  facts.moves_finished = 2;
  return summary;
}

}  // namespace armature::cosim::test
