#include <nlohmann/json.hpp>

#include "controller/core/timebase.hpp"
#include "cosim/report/run_summary.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

using Json = nlohmann::ordered_json;  // keys in the order of writing

Json move_json(const MoveReport& move) {
  Json shapes = Json::array();
  for (const ProfileShape shape : move.shape) shapes.push_back(shape_name(shape));
  return {{"start_tick", move.start_tick.value()},
          {"duration_ticks", move.duration.value()},
          {"profile", std::move(shapes)},
          {"peak_speed_rad_s", move.peak_speed_rad_s},
          {"accel_rad_s2", move.accel_rad_s2}};
}

std::string_view golden_word(GoldenVerdict verdict) {
  switch (verdict) {
    case GoldenVerdict::kEqual:
      return "equal";
    case GoldenVerdict::kDiffers:
      return "differs";
    case GoldenVerdict::kNone:
      break;
  }
  return "none";
}

Json result_json(const RunSummary& summary) {
  const RunFacts& facts = summary.facts;
  Json result = {
      {"passed", summary.passed()},
      {"interrupted", summary.interrupted},
      {"outcome", facts.outcome()},
      {"failure", summary.failure ? Json(*summary.failure) : Json(nullptr)},
      {"simulated_s", summary.simulated_s()},
      {"ticks", facts.ticks},
      {"cycles", summary.cycles.value()},
      {"bus_reads", summary.bus_reads},
      {"bus_writes", summary.bus_writes},
      {"worst_tick_cycles", summary.worst_tick.value()},
      {"tick_cycles", kTickCycles.value()},
      {"moves_finished", facts.moves_finished},
      {"underruns", facts.underruns},
      {"stopped_by", facts.stopped_by.empty() ? Json(nullptr) : Json(facts.stopped_by)},
      {"final_joint_deg", facts.final_joint_deg},
      {"final_error_counts", facts.final_error_counts},
      {"total_pulses", facts.total_pulses},
      {"peak_speed_deg_s", facts.peak_speed_deg_s},
      {"peak_pulses_per_tick", facts.peak_pulses_per_tick},
      {"worst_following_error_deg", facts.worst_following_error_deg},
      {"overshoot_counts", facts.overshoot_counts},
      {"max_correction_pulses", facts.max_correction_pulses},
      {"settle_s", facts.settle_s ? Json(*facts.settle_s) : Json(nullptr)},
      {"sha256", summary.sha256},
      {"golden", golden_word(summary.golden.verdict)},
  };
  result["moves"] = Json::array();
  for (const MoveReport& move : facts.moves) result["moves"].push_back(move_json(move));
  result["refused_moves"] = Json::array();
  for (const RefusedMove& refused : facts.refusals) {
    result["refused_moves"].push_back({{"reason", refusal_name(refused.refusal.reason)},
                                       {"axis", refused.refusal.axis},
                                       {"cycle", refused.at.value()}});
  }
  result["faults"] = Json::array();
  for (const FaultEvent& fault : facts.faults) {
    result["faults"].push_back({{"cause", fault_name(fault.cause)}, {"axis", fault.axis}, {"cycle", fault.at.value()}});
  }
  result["expect_failures"] = Json::array();
  for (const ExpectFailure& failure : summary.expect_failures) {
    result["expect_failures"].push_back({{"key", failure.key}, {"expected", failure.expected}, {"got", failure.got}});
  }
  return result;
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
  const Json document = {
      {"scenario", summary.scenario},
      {"description", summary.description},
      {"robot", summary.robot},
      {"result", result_json(summary)},
      {"host",
       {{"wall_s", summary.host.wall_s},
        {"cycles_per_s", summary.cycles_per_s()},
        {"real_time_factor", summary.real_time_factor()}}},
  };
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace armature::cosim
