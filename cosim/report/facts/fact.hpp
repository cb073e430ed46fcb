// The facts of a run. Each has a name, a unit, a meaning, a function that computes it from the measurements, and the
// keys of [expect] that compare it. fact_list() is the only list of facts. Judging, summary.json, the screen, JUnit and
// scenarios/RESULTS.md use it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/report/facts/fact_value.hpp"
#include "cosim/report/facts/fact_where.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// Where summary.json has a fact, and of which runs.
enum class FactGroup {
  kResult,        // under `result`: of every run
  kPaper,         // under `result.paper`: of the variant of the paper
  kSerial,        // under `result`: if the controller sent something on its serial line
  kOutputs,       // under `result`: if an output of the tool has changed
  kProgram,       // under `result`: if the scenario has a program
  kInstructions,  // under `result`: if the instructions of the cores are charged
  kEvents,        // not by itself: summary.json has the moves, refused moves and faults in more detail
};

// How a value is compared with the expected one.
enum class Relation {
  kEqual,
  // Within a tolerance: the value of each axis, the distance of points, the angle between orientations, or the times of
  // output changes.
  kWithin,
  // Not above, or not below, a limit. For values of all axes the largest is compared.
  kAtMost,
  kAtLeast,
};

// A key of [expect] that compares a fact.
struct Expectation {
  std::string_view key;
  Relation relation = Relation::kEqual;
  // The expected value for a robot with that many axes. Nullopt: the scenario does not have the key.
  std::optional<FactValue> (*wanted)(const ExpectSpec& expect, std::size_t axis_count) = nullptr;
  // kWithin: the tolerance, in the unit of the fact, and the key that gives it. Empty: no key does.
  double (*tolerance)(const ExpectSpec& expect) = nullptr;
  std::string_view tolerance_key{};
};

// A line of the summary on the screen. Values of axes are in columns.
struct ScreenLine {
  std::string_view label{};  // empty: no line
  int digits = 0;            // after the point
  bool unless_zero = false;  // no line for 0, or if the values of all axes are 0
};

struct Fact {
  std::string_view name;  // also the key in summary.json
  std::string_view unit;  // empty: none, or a count of the things in the name
  std::string_view meaning;
  FactValue (*value)(const RunFacts& facts) = nullptr;
  FactGroup group = FactGroup::kResult;
  ScreenLine screen{};
  std::vector<Expectation> expectations{};

  // ---- for messages about expectations; each may be missing
  // The value in words, if value_text() is not enough.
  std::string (*in_words)(const RunFacts& facts) = nullptr;
  // Why no expectation can be met although there is a value. Empty if expectations can be judged.
  std::string (*nothing_to_judge)(const RunFacts& facts) = nullptr;
  FactWhere (*where)(const RunFacts& facts) = nullptr;
  // The place in the run of the value of each axis.
  PerAxis<std::optional<RunPlace>> (*axis_places)(const RunFacts& facts) = nullptr;

  // The required value if the scenario has no expectation of this fact and none of the fact `mentioned_by`. Nullopt:
  // any value.
  struct Otherwise {
    FactValue value;
    std::string_view text;  // for messages
    std::string_view mentioned_by{};
  };
  std::optional<Otherwise> otherwise{};
};

// All facts, in the order in which reports show them.
[[nodiscard]] const std::vector<Fact>& fact_list();

// The entry of that name, which must exist.
[[nodiscard]] const Fact& fact_named(std::string_view name);

}  // namespace armature::cosim
