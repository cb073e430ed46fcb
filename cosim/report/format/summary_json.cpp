#include "cosim/report/format/summary_json.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "cosim/report/format/injection_text.hpp"
#include "cosim/report/format/refusal_text.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/text/angle_units.hpp"
#include "cosim/text/byte_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using Json = nlohmann::ordered_json;  // keys in the order of writing

Json vector_json(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

// The axes that the robot has.
template <class T>
Json axes_json(const PerAxis<T>& values, std::size_t axis_count) {
  Json array = Json::array();
  for (std::size_t i = 0; i < axis_count; ++i) array.push_back(values[i]);
  return array;
}

PerAxis<double> in_degrees(PerAxis<double> values) {
  for (double& value : values) value *= kDegPerRad;
  return values;
}

Json path_json(const PositionPath& path) {
  Json json = {
      {"length_mm", path.length_mm}, {"start_mm", vector_json(path.start_mm)}, {"end_mm", vector_json(path.end_mm)}};
  if (path.shape == PositionPath::Shape::kArc) {
    json["center_mm"] = vector_json(path.center_mm);
    json["radius_mm"] = path.radius_mm;
    json["angle_deg"] = path.angle_rad * kDegPerRad;
    json["normal"] = vector_json(path.x.cross(path.y));
  }
  return json;
}

Json move_json(const MoveStarted& move, std::size_t axis_count) {
  Json json = {{"move", move.tag.number()},
               {"kind", move_name(move)},
               {"start_tick", move.start_tick.value()},
               {"duration_ticks", move.duration.value()},
               {"residual_deg", move.residual_rad * kDegPerRad}};
  if (move.kind == MoveKind::kJoint) {
    Json shapes = Json::array();
    for (std::size_t i = 0; i < axis_count; ++i) shapes.push_back(shape_name(move.shape[i]));
    json["profile"] = std::move(shapes);
    json["peak_speed_deg_s"] = axes_json(in_degrees(move.peak_speed_rad_s), axis_count);
    json["accel_deg_s2"] = axes_json(in_degrees(move.accel_rad_s2), axis_count);
  } else {
    json["stretch"] = move.stretch;
    json["stretched_for_axis"] = move.stretched_for;
    json["continues"] = move.continues;
    json["path"] = path_json(move.path);
  }
  return json;
}

Json refused_json(const RefusedMove& refused) {
  const MoveRefused& refusal = refused.refusal;
  Json json = {{"move", refusal.tag.number()},
               {"reason", refusal_name(refusal.reason)},
               {"axis", refusal.axis},
               {"cycle", refused.at.value()},
               {"text", refusal_text(refusal)}};
  if (refusal.path.kind != PathProblem::Kind::kNone) {
    const PathProblem& path = refusal.path;
    json["path"] = {{"segment", path.segment},     {"at", path.at},
                    {"axis", path.axis},           {"singular", singularity_names(path.singular)},
                    {"margin_mm", path.margin_mm}, {"residual_deg", path.residual_rad * kDegPerRad},
                    {"stretch", path.stretch}};
  }
  return json;
}

Json deviation_json(const std::optional<PathDeviation>& deviation) {
  if (!deviation) return nullptr;
  return {
      {"mm", deviation->mm}, {"tick", deviation->tick}, {"cycle", deviation->at.value()}, {"move", deviation->move}};
}

Json cycle_json(const std::optional<Cycles>& at) {
  return at ? Json(at->value()) : Json(nullptr);
}

Json fault_json(const FaultEvent& fault) {
  return {{"cause", fault_name(fault.cause)}, {"axis", fault.axis}, {"cycle", fault.at.value()}, {"tick", fault.tick}};
}

Json injected_json(const InjectedFault& fault) {
  Json json = {{"kind", fault_kind_name(fault.spec.kind)}, {"cycle", fault.when.at.value()}, {"tick", fault.when.tick}};
  switch (fault.spec.kind) {
    case FaultKind::kPulseLoss:
      json["axis"] = fault.spec.axis;
      json["count"] = fault.spec.count;
      json["lost_pulses"] = fault.lost_pulses;
      json["max_correction_pulses"] = fault.max_correction_pulses;
      break;
    case FaultKind::kSlowCore:
      json["compute_us"] = fault.spec.compute_us;
      break;
    case FaultKind::kEstop:
      json["duration_s"] = fault.spec.duration_s;
      json["released_cycle"] = cycle_json(fault.released);
      break;
  }
  json["underruns"] = fault.underruns;
  json["servo_off_cycle"] = cycle_json(fault.servo_off);
  json["fault"] = fault.fault ? fault_json(*fault.fault) : Json(nullptr);
  json["text"] = answer_text(fault);
  return json;
}

Json input_json(const GivenInput& input) {
  return {{"pin", input.spec.pin},
          {"level", input.spec.level ? 1 : 0},
          {"cycle", input.when.at.value()},
          {"tick", input.when.tick},
          {"accepted_by_move", input.accepted_by ? Json(*input.accepted_by) : Json(nullptr)},
          {"accepted_cycle", input.accepted_by ? Json(input.accepted_at.value()) : Json(nullptr)},
          {"text", answer_text(input)}};
}

Json failure_json(const ExpectFailure& failure) {
  const std::optional<FactPlace>& at = failure.where.at;
  return {{"key", failure.key},
          {"place", failure.place()},
          {"expected", failure.expected},
          {"got", failure.got},
          {"where", failure.where.text},
          {"axes", failure.where.axes},
          {"tick", at ? Json(at->tick) : Json(nullptr)},
          {"time_s", at ? Json(to_seconds(at->at)) : Json(nullptr)},
          {"text", failure.text()}};
}

Json inputs_json(const std::vector<InputFile>& inputs) {
  Json array = Json::array();
  for (const InputFile& input : inputs) array.push_back({{"file", input.file}, {"sha256", input.sha256}});
  return array;
}

Json result_json(const RunSummary& summary) {
  const RunFacts& facts = summary.facts;
  Json result = {
      {"passed", summary.passed()},
      {"interrupted", summary.interrupted},
      {"outcome", summary.outcome()},
      {"failure", summary.failure ? Json(*summary.failure) : Json(nullptr)},
      {"simulated_s", summary.simulated_s()},
      {"ticks", facts.ticks},
      {"cycles", summary.cycles.value()},
      {"bus_reads", summary.bus_reads},
      {"bus_writes", summary.bus_writes},
      {"worst_tick_cycles", summary.worst_tick.value()},
      {"tick_cycles", kTickCycles},
      {"moves_finished", facts.moves_finished},
      {"moves_waiting", facts.moves_waiting},
      {"moves_under_way", facts.moves_under_way},
      {"blended_moves", facts.blended_moves()},
      {"held_s", facts.held_s},
      {"underruns", facts.underruns},
      {"stopped_by", facts.stopped_by.empty() ? Json(nullptr) : Json(facts.stopped_by)},
      {"final_joint_deg", axes_json(facts.final_joint_deg, facts.axis_count)},
      {"final_error_counts", axes_json(facts.final_error_counts, facts.axis_count)},
      {"total_pulses", axes_json(facts.total_pulses, facts.axis_count)},
      {"peak_speed_deg_s", axes_json(facts.peak_speed_deg_s, facts.axis_count)},
      {"peak_pulses_per_tick", facts.peak_pulses_per_tick},
      {"worst_following_error_deg", axes_json(facts.worst_following_error_deg, facts.axis_count)},
      {"overshoot_counts", axes_json(facts.overshoot_counts, facts.axis_count)},
      {"max_correction_pulses", facts.max_correction_pulses},
      {"settle_s", facts.settle_s ? Json(*facts.settle_s) : Json(nullptr)},
      {"final_tcp_mm", facts.final_tcp_mm ? vector_json(*facts.final_tcp_mm) : Json(nullptr)},
      {"final_rpy_deg", facts.final_rotation ? Json(rpy_deg(*facts.final_rotation)) : Json(nullptr)},
      {"path_error", deviation_json(facts.path_error)},
      {"command_path_error", deviation_json(facts.command_path_error)},
      {"largest_stretch", facts.largest_stretch()},
      {"sha256", summary.sha256},
      {"golden", summary.golden.word()},
      {"golden_text", summary.golden.text},
  };
  if (summary.variant == Variant::kPaper) {
    result["paper"] = {{"inexact_ticks", axes_json(facts.inexact_ticks, facts.axis_count)},
                       {"max_residual_pulses", facts.max_residual_pulses},
                       {"lost_counts", axes_json(facts.lost_counts, facts.axis_count)}};
  }
  if (!facts.serial_sent.empty() || facts.serial_errors > 0) {
    result["serial_sent_hex"] = hex_of_bytes(facts.serial_sent);
    result["serial_errors"] = facts.serial_errors;
  }
  if (!facts.outputs.empty()) {
    result["outputs"] = Json::array();
    for (const OutputChange& change : facts.outputs) {
      result["outputs"].push_back({{"pin", change.pin}, {"level", change.level ? 1 : 0}, {"cycle", change.at.value()}});
    }
    result["final_outputs"] = facts.high_outputs();
  }
  result["moves"] = Json::array();
  for (std::size_t i = 0; i < facts.moves.size(); ++i) {
    Json move = move_json(facts.moves[i], facts.axis_count);
    move["taken_ticks"] = facts.taken_ticks[i] ? Json(*facts.taken_ticks[i]) : Json(nullptr);
    const std::optional<bool> blended = facts.blended_with_next(i);
    move["blended"] = blended ? Json(*blended) : Json(nullptr);
    result["moves"].push_back(std::move(move));
  }
  result["refused_moves"] = Json::array();
  for (const RefusedMove& refused : facts.refusals) {
    result["refused_moves"].push_back(refused_json(refused));
  }
  result["faults"] = Json::array();
  for (const FaultEvent& fault : facts.faults) {
    result["faults"].push_back(fault_json(fault));
  }
  result["injected_faults"] = Json::array();
  for (const InjectedFault& fault : facts.injected_faults) {
    result["injected_faults"].push_back(injected_json(fault));
  }
  result["inputs"] = Json::array();
  for (const GivenInput& input : facts.inputs) result["inputs"].push_back(input_json(input));
  result["expect_failures"] = Json::array();
  for (const ExpectFailure& failure : summary.expect_failures) {
    result["expect_failures"].push_back(failure_json(failure));
  }
  return result;
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
  const Json document = {
      {"scenario", summary.scenario},
      {"description", summary.description},
      {"robot", summary.robot},
      {"variant", variant_name(summary.variant)},
      {"engine", engine_name(summary.engine)},
      {"seed", summary.seed},
      {"overrides", summary.overrides},
      {"inputs", inputs_json(summary.sources)},
      {"tool_version", summary.tool_version},
      {"result", result_json(summary)},
      {"host",
       {{"wall_s", summary.host.wall_s},
        {"cycles_per_s", summary.cycles_per_s()},
        {"real_time_factor", summary.real_time_factor()}}},
  };
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace armature::cosim
