#include "cosim/report/format/json/event_json.hpp"

#include <optional>
#include <string>
#include <variant>

#include "controller/base/angle_units.hpp"
#include "controller/base/overloaded.hpp"
#include "cosim/report/format/injection_text.hpp"
#include "cosim/report/format/json/command_json.hpp"
#include "cosim/report/format/json/message_json.hpp"
#include "cosim/report/format/refusal_text.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

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

Json path_json(const MoveStarted& move) {
  const PathGeometry& path = move.path;
  Json json = {
      {"length_mm", path.length_mm}, {"start_mm", vector_json(path.start_mm)}, {"end_mm", vector_json(path.end_mm)}};
  if (path.shape == PathGeometry::Shape::kArc) {
    json["center_mm"] = vector_json(path.center_mm);
    json["radius_mm"] = path.radius_mm;
    json["angle_deg"] = path.angle_rad * kDegPerRad;
    json["normal"] = vector_json(path.x.cross(path.y));
    if (path.advance_mm != 0) json["advance_mm"] = path.advance_mm;
  }
  if (path.shape == PathGeometry::Shape::kSpline) {
    Json points = Json::array();
    for (const Eigen::Vector3d& point : move.through.view()) points.push_back(vector_json(point));
    json["through_mm"] = std::move(points);
  }
  return json;
}

Json key_json(const KeyValue& value) {
  return std::visit(Overloaded{[](std::monostate) { return Json(nullptr); }, [](const auto& it) { return Json(it); }},
                    value);
}

Json cycle_json(const std::optional<Cycles>& at) {
  return at ? Json(at->value()) : Json(nullptr);
}

}  // namespace

Json move_json(const RunFacts& facts, std::size_t i) {
  const MoveStarted& move = facts.moves[i];
  const std::size_t axis_count = facts.axis_count;
  Json json = command_json(move.tag, facts.names);
  json["kind"] = move_name(move);
  json["start_tick"] = move.start_tick.value();
  json["duration_ticks"] = move.duration.value();
  json["residual_deg"] = move.residual_rad * kDegPerRad;
  if (move.kind == MoveKind::kJoint) {
    Json shapes = Json::array();
    for (std::size_t axis = 0; axis < axis_count; ++axis) shapes.push_back(word_of(move.shape[axis]));
    json["profile"] = std::move(shapes);
    json["peak_speed_deg_s"] = axes_json(in_degrees(move.peak_speed_rad_s), axis_count);
    json["accel_deg_s2"] = axes_json(in_degrees(move.accel_rad_s2), axis_count);
  } else if (is_path(move.kind)) {
    json["stretch"] = move.stretch;
    json["stretched_for_axis"] = move.stretched_for;
    json["continues"] = move.continues;
    if (move.unasked_stop) json["unasked_stop"] = true;
    if (move.rapid) json["rapid"] = true;
    json["path"] = path_json(move);
    if (move.on_conveyor) json["on_conveyor"] = true;
  }
  json["taken_ticks"] = facts.taken_ticks[i] ? Json(*facts.taken_ticks[i]) : Json(nullptr);
  const std::optional<bool> blended = facts.blended_with_next(i);
  json["blended"] = blended ? Json(*blended) : Json(nullptr);
  return json;
}

Json event_json(const JogRun& jog, const CommandNames& names) {
  Json json = command_json(jog.started.tag, names);
  json["start_tick"] = jog.started.tick.value();
  const std::optional<JogEnded>& end = jog.ended;
  json["taken_ticks"] = end ? Json(end->taken.value()) : Json(nullptr);
  json["ended_by"] = end ? Json(word_of(end->how)) : Json(nullptr);
  json["axis"] = end ? end->axis : 0;
  json["commands"] = end ? Json(end->commands) : Json(nullptr);
  return json;
}

Json event_json(const HomingRun& axis, const CommandNames& names) {
  Json json = command_json(axis.started.tag, names);
  json["axis"] = axis.started.axis;
  json["start_tick"] = axis.started.tick.value();
  const std::optional<HomingEnded>& end = axis.ended;
  const bool homed = end && end->how == HomingEnd::kHomed;
  json["taken_ticks"] = end ? Json(end->taken.value()) : Json(nullptr);
  json["ended_by"] = end ? Json(word_of(end->how)) : Json(nullptr);
  json["met"] = end ? Json(homing_switch_text(end->met)) : Json(nullptr);
  json["edge_to_index_counts"] = homed ? Json(end->edge_to_index.value()) : Json(nullptr);
  json["shift_counts"] = homed ? Json(end->shift.value()) : Json(nullptr);
  return json;
}

Json event_json(const RefusedMove& refused, const CommandNames& names) {
  const MoveRefused& refusal = refused.refusal;
  Json json = command_json(refusal.tag, names);
  json["reason"] = word_of(refusal.reason);
  json["axis"] = refusal.axis;
  json["cycle"] = refused.at.value();
  json["text"] = refusal_text(refusal);
  if (refusal.reason == Refusal::kOutsideLimits) {
    json["target_deg"] = refusal.path.angle_rad * kDegPerRad;
    json["limit_deg"] = refusal.path.limit_rad * kDegPerRad;
  }
  if (refusal.path.kind != PathProblem::Kind::kNone) {
    const PathProblem& path = refusal.path;
    json["path"] = {{"segment", path.segment},     {"at", path.at},
                    {"axis", path.axis},           {"singular", singularity_names(path.singular)},
                    {"margin_mm", path.margin_mm}, {"residual_deg", path.residual_rad * kDegPerRad},
                    {"stretch", path.stretch},     {"configuration", configuration_part_names(path.configuration)}};
  }
  return json;
}

Json event_json(const ProgramEvent& event, const CommandNames& names) {
  const ProgramLine at = names.line(event.note.place);
  return {{"kind", word_of(event.note.kind)},
          {"line", at.line},
          {"file", at.file},
          {"text", event.note.view()},
          {"cycle", event.at.value()}};
}

Json event_json(const OtherEvent& other) {
  return std::visit(
      [&]<class T>(const T& event) -> Json {
        return {{"event", type_name_of<T>()}, {"cycle", other.at.value()}, {"members", message_json(event)}};
      },
      other.event);
}

Json event_json(const FaultEvent& fault) {
  return {{"cause", word_of(fault.cause)},
          {"axis", fault.where.axis},
          {"cycle", fault.where.at.value()},
          {"tick", fault.where.tick}};
}

Json event_json(const FaultEvent& fault, const RunFacts& facts) {
  Json json = event_json(fault);
  json["because_of"] = cause_text(facts, fault.where);
  return json;
}

Json event_json(const BusAbortEvent& abort) {
  return {{"core", abort.core},
          {"access", abort.write ? "write" : "read"},
          {"address", abort.address},
          {"error", bus_error_name(abort.error)},
          {"cycle", abort.where.at.value()},
          {"tick", abort.where.tick},
          {"text", abort_text(abort)}};
}

Json event_json(const InjectedFault& fault) {
  Json json = {{"kind", fault_kind_name(fault.spec.kind)}, {"cycle", fault.when.at.value()}, {"tick", fault.when.tick}};
  for (const NamedValue& parameter : fault_parameters(fault.spec.kind)) {
    json[std::string{parameter.key}] = key_json(parameter.value);
  }
  if (std::holds_alternative<PulseLoss>(fault.spec.kind)) {
    json["lost_pulses"] = fault.lost_pulses;
    json["max_correction_pulses"] = fault.max_correction_pulses;
  }
  if (fault_duration_s(fault.spec.kind)) json["released_cycle"] = cycle_json(fault.ended);
  json["underruns"] = fault.underruns;
  json["servo_off_cycle"] = cycle_json(fault.servo_off);
  json["fault"] = fault.fault ? event_json(*fault.fault) : Json(nullptr);
  json["answered"] = fault.answered;
  json["text"] = answer_text(fault);
  return json;
}

Json event_json(const GivenInput& input, const CommandNames& names) {
  return {{"pin", input.spec.pin},
          {"level", input.spec.level ? 1 : 0},
          {"cycle", input.when.at.value()},
          {"tick", input.when.tick},
          {"accepted_by_move", input.accepted_by ? Json(*input.accepted_by) : Json(nullptr)},
          {"accepted_by_line", input.accepted_by_line ? Json(names.line_text(*input.accepted_by_line)) : Json(nullptr)},
          {"accepted_cycle", input.accepted() ? Json(input.accepted_at.value()) : Json(nullptr)},
          {"text", answer_text(input, names)}};
}

Json event_json(const ExpectResult& result) {
  return {{"key", result.key},
          {"expected", result.expected},
          {"got", result.got},
          {"met", result.met},
          {"margin", result.margin ? Json(*result.margin) : Json(nullptr)}};
}

Json event_json(const ExpectFailure& failure) {
  const std::optional<RunPlace>& at = failure.where.at;
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

}  // namespace armature::cosim
