#include "cosim/report/format/json/summary_json.hpp"

#include "cosim/report/facts/fact.hpp"
#include "cosim/report/format/json/arm_json.hpp"
#include "cosim/report/format/json/event_json.hpp"
#include "cosim/report/format/json/fact_json.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

Json sources_json(const std::vector<InputFile>& sources) {
  Json array = Json::array();
  for (const InputFile& source : sources) array.push_back({{"file", source.file}, {"sha256", source.sha256}});
  return array;
}

void add_facts(Json& json, const RunSummary& summary, FactGroup group) {
  if (!summary.has(group)) return;
  for (const Fact& fact : fact_list()) {
    if (fact.group == group) json[std::string{fact.name}] = fact_json(fact.value(summary.facts));
  }
}

template <class Events>
Json events_json(const Events& events) {
  Json array = Json::array();
  for (const auto& event : events) array.push_back(event_json(event));
  return array;
}
template <class Events>
Json events_json(const Events& events, const CommandNames& names) {
  Json array = Json::array();
  for (const auto& event : events) array.push_back(event_json(event, names));
  return array;
}

Json result_json(const RunSummary& summary) {
  const RunFacts& facts = summary.facts;
  Json result = {
      {"passed", summary.passed()},
      {"interrupted", summary.interrupted},
      {"outcome", summary.outcome()},
      {"failure", summary.failure ? Json(*summary.failure) : Json(nullptr)},
  };
  add_facts(result, summary, FactGroup::kResult);
  result["golden"] = summary.golden.word();
  result["golden_text"] = summary.golden.text;
  if (summary.has(FactGroup::kPaper)) add_facts(result["paper"], summary, FactGroup::kPaper);
  add_facts(result, summary, FactGroup::kSerial);
  add_facts(result, summary, FactGroup::kOutputs);
  add_facts(result, summary, FactGroup::kInstructions);
  add_facts(result, summary, FactGroup::kProgram);
  if (summary.has(FactGroup::kProgram)) result["program"] = events_json(facts.program_events, facts.names);
  result["moves"] = Json::array();
  for (std::size_t i = 0; i < facts.moves.size(); ++i) result["moves"].push_back(move_json(facts, i));
  result["jogs"] = events_json(facts.jogs, facts.names);
  result["homings"] = events_json(facts.homings, facts.names);
  result["refused_moves"] = events_json(facts.refusals, facts.names);
  result["faults"] = Json::array();
  for (const FaultEvent& fault : facts.faults) result["faults"].push_back(event_json(fault, facts));
  const std::string first = first_fault_text(facts);
  result["first_fault"] = first.empty() ? Json(nullptr) : Json(first);
  // Only new kinds of events are here, so that most summaries do not have the key.
  for (const OtherEvent& other : facts.other_events) result["events"].push_back(event_json(other));
  result["bus_aborts"] = events_json(facts.bus_aborts);
  result["injected_faults"] = events_json(facts.injected_faults);
  result["inputs"] = events_json(facts.inputs, facts.names);
  result["expectations"] = events_json(summary.expect_results);
  result["expect_failures"] = events_json(summary.expect_failures);
  return result;
}

Json wave_json(const MomentWaveResult& wave) {
  const auto if_written = [&](auto value) { return wave.written() ? Json(value) : Json(nullptr); };
  return {{"file", wave.file},
          {"written", wave.written()},
          {"why_not", wave.written() ? Json(nullptr) : Json(wave.why_not)},
          {"moment", if_written(wave.moment)},
          {"at_s", if_written(to_seconds(wave.at))},
          {"from_s", if_written(to_seconds(wave.from))},
          {"to_s", if_written(to_seconds(wave.to))}};
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
  Json document = {
      {"scenario", summary.scenario},
      {"description", summary.description},
      {"robot", summary.robot},
      {"variant", word_of(summary.variant)},
      {"engine", word_of(summary.engine)},
      {"seed", summary.seed},
      {"overrides", summary.overrides},
      {"inputs", sources_json(summary.sources)},
      {"tool_version", summary.tool_version},
      {"arm", arm_json(summary.arm, summary.tool)},
      {"frames", frames_json(summary.frames)},
      {"program_frame", summary.program_frame ? Json(*summary.program_frame) : Json(nullptr)},
      {"result", result_json(summary)},
      {"host",
       {{"wall_s", summary.host.wall_s},
        {"cycles_per_s", summary.cycles_per_s()},
        {"real_time_factor", summary.real_time_factor()},
        {"whole_ticks", summary.host.whole_ticks}}},
  };
  if (summary.moment_wave) document["waveform"] = wave_json(*summary.moment_wave);
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace armature::cosim
