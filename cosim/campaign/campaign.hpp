// A campaign: runs with random robots, moves and faults, each of which is judged.
//
// The runs of a group have the same robot and moves. The first has no fault: it shows where the others must end. The
// result of a run depends on the seed and the number of the run alone.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/campaign/campaign_case.hpp"
#include "cosim/campaign/judge/outcome.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"

namespace armature::cosim {

inline constexpr std::int64_t kGroupRuns = 6;

struct CampaignSpec {
  std::uint64_t seed = 1;
  std::vector<RobotSpec> robots;     // not empty
  std::vector<std::string> kinds{};  // of faults that are drawn; empty: all of fault_kind_names()
  LoadOptions load{};                // with the engine
  // Changes the system under test, not what the judge expects: a test plants errors by it.
  std::function<void(Scenario&)> plant_error{};
};

struct CampaignResult {
  std::int64_t run = 0;
  std::vector<std::string> kinds{};   // of its faults, in the order of time
  std::vector<std::string> faults{};  // in words: `pulse_loss of axis 3, 500 pulses at 0.1 s`
  Verdict verdict{};
  CampaignCase drawn{};
};

// The runs of a group, in their order. `wanted`: numbers of runs; the first run of the group is always computed.
// `folder`: for the files of the scenarios. `stop`: is asked often; the group is given up, and the result empty.
[[nodiscard]] std::vector<CampaignResult> run_group(const CampaignSpec& spec, std::int64_t group,
                                                    const std::filesystem::path& folder,
                                                    const std::function<bool(std::int64_t)>& wanted,
                                                    const std::function<bool()>& stop);

// The runs `drawn` without and with its faults, and judges the second.
[[nodiscard]] CampaignResult run_case(const CampaignSpec& spec, const CampaignCase& drawn,
                                      const std::filesystem::path& folder);

}  // namespace armature::cosim
