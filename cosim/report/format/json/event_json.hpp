// What happened in a run as JSON: moves, refused moves, faults, bus errors, inputs, missed expectations.
// scenarios/RESULTS.md describes the keys.
#pragma once

#include "cosim/report/format/json/fact_json.hpp"
#include "cosim/report/judge/expect_failure.hpp"
#include "cosim/report/judge/expect_result.hpp"
#include "cosim/report/measure/run_facts.hpp"

namespace armature::cosim {

[[nodiscard]] Json event_json(const JogRun& jog, const CommandNames& names);
[[nodiscard]] Json event_json(const HomingRun& axis, const CommandNames& names);
[[nodiscard]] Json event_json(const RefusedMove& refused, const CommandNames& names);
[[nodiscard]] Json event_json(const ProgramEvent& event, const CommandNames& names);
[[nodiscard]] Json event_json(const OtherEvent& other);
[[nodiscard]] Json event_json(const FaultEvent& fault);
[[nodiscard]] Json event_json(const FaultEvent& fault, const RunFacts& facts);  // with its causes
[[nodiscard]] Json event_json(const BusAbortEvent& abort);
[[nodiscard]] Json event_json(const InjectedFault& fault);
[[nodiscard]] Json event_json(const GivenInput& input, const CommandNames& names);
[[nodiscard]] Json event_json(const ExpectResult& result);
[[nodiscard]] Json event_json(const ExpectFailure& failure);

// facts.moves[i].
[[nodiscard]] Json move_json(const RunFacts& facts, std::size_t i);

}  // namespace armature::cosim
