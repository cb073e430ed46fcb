// One run of a campaign before it is a scenario: parts that were drawn, and that can be left out one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// Steps at the begin and at the end of each case, which are needed to judge it. They are not left out.
inline constexpr std::size_t kFirstSteps = 2, kLastSteps = 1;

struct CampaignCase {
  std::string description{};
  std::string robot{};
  std::uint64_t seed = 1;
  double duration_s = 0;
  std::string keys{};                 // further keys of the file, and its tables but those below: lines of TOML
  std::vector<std::string> steps{};   // tables [[move]], or lines of the robot program if there are places
  std::vector<std::string> places{};  // joint angles of a robot program: `10,20,30,40,50,60`
  std::vector<std::string> faults{};  // tables [[fault]]

  [[nodiscard]] bool has_program() const { return !places.empty(); }
};

// The text of the scenario file, and that of the robot program, whose file is `program.jbi`.
[[nodiscard]] std::string scenario_text(const CampaignCase& drawn);
[[nodiscard]] std::string program_text(const CampaignCase& drawn);

// Writes the files into `folder`.
void write_case(const CampaignCase& drawn, const std::filesystem::path& folder);
// The same, and loads them. Throws InputError.
[[nodiscard]] Scenario load_case(const CampaignCase& drawn, const std::filesystem::path& folder,
                                 const LoadOptions& options);

}  // namespace armature::cosim
