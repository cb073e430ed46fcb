#include "cosim/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/campaign/draw_fault.hpp"
#include "cosim/campaign/draw_moves.hpp"
#include "cosim/campaign/judge/judge.hpp"
#include "cosim/campaign/judge/judge_limits.hpp"
#include "cosim/campaign/judge/true_path.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr double kLongestRunS = 8;  // of a run without faults
constexpr double kMoreTime = 4.5;   // of a run with faults, which can be slower
constexpr Cycles kSlice{200 * armature::kTickCycles.value()};
// After the last move, at most: an elastic arm may swing as long.
constexpr Cycles kRest{2'000 * armature::kTickCycles.value()};
constexpr int kDraws = 50;  // of a fault, until the loader takes it

enum Stream : std::uint8_t { kMoveStream, kFaultStream };

// The run without faults.
struct Base {
  TruePath path;
  Verdict verdict;
  double first_s = 0, last_s = 0;  // when faults may begin
};

struct Asked {
  const CampaignSpec& spec;
  const std::filesystem::path& folder;
  const std::function<bool()>& stop;
};

const RobotSpec& robot_of(const CampaignSpec& spec, const std::string& name) {
  return *std::ranges::find(spec.robots, name, &RobotSpec::name);
}

Scenario load(const Asked& asked, const CampaignCase& drawn) {
  Scenario scenario = load_case(drawn, asked.folder, asked.spec.load);
  if (asked.spec.plant_error) asked.spec.plant_error(scenario);
  return scenario;
}

bool is_over(const RunFacts& facts, bool has_program) {
  const bool idle = facts.moves_waiting == 0 && facts.moves_under_way == 0 && !facts.moves.empty();
  if (!has_program || !idle) return idle;
  return !facts.program_events.empty() && facts.program_end() != "running" && facts.program_end() != "waiting";
}

// Runs until all moves have ended and the arm stands, or until `limit`. Returns false if the user has stopped it.
bool run_to_end(Run& run, const TruePathRecorder& path, bool has_program, const std::function<bool()>& stop) {
  std::optional<Cycles> over;
  while (run.advance(run.now() + kSlice)) {
    if (stop && stop()) return false;
    if (!over && is_over(run.facts(), has_program)) over = run.now();
    if (over && (path.motors_stand() || run.now() >= *over + kRest)) break;
  }
  return true;
}

bool has_missed(const RunFacts& facts, const RobotSpec& robot, const PerAxis<double>& end_deg) {
  constexpr double kNear = 0.01;  // half a pulse of the coarsest axis, and some counts
  if (robot.plant == kDynamicPlant) return false;
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    if (std::fabs(facts.final_joint_deg[i] - end_deg[i]) > kNear) return true;
  }
  return false;
}

// `end_deg`: where the moves were drawn to end, if that is known.
std::optional<Base> run_base(const Asked& asked, CampaignCase drawn, const PerAxis<double>* end_deg) {
  drawn.faults.clear();
  drawn.duration_s = kLongestRunS;
  const Scenario scenario = load(asked, drawn);
  const RobotSpec& robot = robot_of(asked.spec, drawn.robot);
  const JudgeLimits limits = judge_limits(robot);
  const TruePath nothing;
  TruePathRecorder recorder;
  CampaignJudge judge{limits, nothing, Cycles{}};
  Run run{scenario};
  run.add(recorder);
  run.add(judge);
  if (!run_to_end(run, recorder, drawn.has_program(), asked.stop)) return std::nullopt;
  const RunSummary summary = run.finish();
  Base base{.path = recorder.path(), .verdict = judge.verdict(summary.failure)};
  const RunFacts& facts = summary.facts;
  const auto begin_of = [&](const MoveStarted& move) {
    return static_cast<double>(move.start_tick.value()) * to_seconds(armature::kTickCycles);
  };
  if (facts.moves.size() > kFirstSteps) {
    base.first_s = begin_of(facts.moves[kFirstSteps]);
    base.last_s = begin_of(facts.moves.back());
  }
  if (is_silent(base.verdict.outcome)) return base;
  if (base.verdict.outcome == Outcome::kStopped) {
    base.verdict.outcome = Outcome::kWrongFault;
  } else if (!is_over(facts, drawn.has_program())) {
    base.verdict = {.outcome = Outcome::kHang, .reason = "the moves do not end"};
  } else if (end_deg != nullptr && has_missed(facts, robot, *end_deg)) {
    base.verdict = {.outcome = Outcome::kWrongPosition, .reason = "the last target is missed"};
  }
  return base;
}

double rounded_up_s(double seconds) {
  return std::ceil(seconds * 1e3) / 1e3;
}

double duration_for(const Base& base) {
  const double end_s = static_cast<double>(base.path.points.size()) * to_seconds(armature::kTickCycles);
  return rounded_up_s(end_s * kMoreTime + to_seconds(kRest));
}

Cycles end_of_faults(const Scenario& scenario) {
  double end_s = 0;
  for (const FaultSpec& fault : scenario.faults) {
    end_s = std::max(end_s, fault.at_s + fault_duration_s(fault.kind).value_or(0));
  }
  return to_cycles(end_s);
}

void name_faults(const Scenario& scenario, CampaignResult& result) {
  for (const FaultSpec& fault : scenario.faults) {
    result.kinds.emplace_back(fault_kind_name(fault.kind));
    result.faults.push_back(fmt::format("{} at {} s", fault_text(fault), fixed_text(fault.at_s, 6)));
  }
}

std::optional<CampaignResult> run_with_faults(const Asked& asked, const CampaignCase& drawn, const Scenario& scenario,
                                              const Base& base) {
  CampaignResult result{.drawn = drawn};
  name_faults(scenario, result);
  const JudgeLimits limits = judge_limits(robot_of(asked.spec, drawn.robot));
  CampaignJudge judge{limits, base.path, end_of_faults(scenario)};
  Run run{scenario};
  run.add(judge);
  while (run.advance(run.now() + kSlice) && !judge.may_end()) {
    if (asked.stop && asked.stop()) return std::nullopt;
  }
  result.verdict = judge.verdict(run.finish().failure);
  return result;
}

// The case with faults that the loader takes, and its scenario.
Scenario with_faults(const Asked& asked, std::int64_t number, const Base& base, CampaignCase& drawn) {
  Draw draw{asked.spec.seed, kFaultStream, static_cast<std::uint64_t>(number)};
  const std::int64_t count = number % kGroupRuns == kGroupRuns - 1 ? 2 : 1;
  const RobotSpec& robot = robot_of(asked.spec, drawn.robot);
  for (int i = 0;; ++i) {
    drawn.faults.clear();
    for (std::int64_t j = 0; j < count; ++j) {
      drawn.faults.push_back(draw_fault(draw, robot, draw.number(base.first_s, base.last_s), asked.spec.kinds));
    }
    try {
      return load(asked, drawn);
    } catch (const InputError&) {
      if (i == kDraws) throw;
    }
  }
}

}  // namespace

std::vector<CampaignResult> run_group(const CampaignSpec& spec, std::int64_t group, const std::filesystem::path& folder,
                                      const std::function<bool(std::int64_t)>& wanted,
                                      const std::function<bool()>& stop) {
  const Asked asked{spec, folder, stop};
  Draw draw{spec.seed, kMoveStream, static_cast<std::uint64_t>(group)};
  const DrawnMoves moves = draw_moves(draw, spec.robots);
  const std::optional<Base> base = run_base(asked, moves.drawn, &moves.end_deg);
  if (!base) return {};
  std::vector<CampaignResult> results;
  for (std::int64_t i = 0; i < kGroupRuns; ++i) {
    const std::int64_t number = group * kGroupRuns + i;
    if (!wanted(number)) continue;
    CampaignCase drawn = moves.drawn;
    drawn.description = fmt::format("Run {} of a campaign with seed {}", number, spec.seed);
    drawn.duration_s = duration_for(*base);
    CampaignResult result{.verdict = base->verdict, .drawn = drawn};
    if (i > 0 && !is_silent(base->verdict.outcome)) {
      const Scenario scenario = with_faults(asked, number, *base, drawn);
      std::optional<CampaignResult> judged = run_with_faults(asked, drawn, scenario, *base);
      if (!judged) return {};
      result = *std::move(judged);
    }
    result.run = number;
    results.push_back(std::move(result));
  }
  return results;
}

CampaignResult run_case(const CampaignSpec& spec, const CampaignCase& drawn, const std::filesystem::path& folder) {
  const std::function<bool()> never;
  const Asked asked{spec, folder, never};
  const Base base = run_base(asked, drawn, nullptr).value();
  if (drawn.faults.empty() || is_silent(base.verdict.outcome)) return {.verdict = base.verdict, .drawn = drawn};
  return run_with_faults(asked, drawn, load(asked, drawn), base).value();
}

}  // namespace armature::cosim
