// Some groups of a campaign, several of them at the same time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "cosim/campaign/campaign.hpp"

namespace armature::cosim {

struct CampaignPart {
  std::vector<std::int64_t> groups{};
  int jobs = 1;
  std::function<bool(std::int64_t)> wanted{};   // runs of the groups, by their numbers
  std::function<bool()> stop{};                 // is asked often; the groups under way are given up
  std::function<void(std::size_t)> progress{};  // how many groups are done; one call at a time; empty: nobody asks
};

// The results in the order of the groups, whatever the number of jobs. `folder`: for files of scenarios.
[[nodiscard]] std::vector<CampaignResult> run_part(const CampaignSpec& spec, const CampaignPart& part,
                                                   const std::filesystem::path& folder);

}  // namespace armature::cosim
