// The table of a campaign for people and for CI servers.
#pragma once

#include <string>
#include <vector>

#include "cosim/campaign/campaign_table.hpp"
#include "cosim/report/format/junit.hpp"

namespace armature::cosim {

[[nodiscard]] std::string campaign_text(const CampaignTable& table);
// `replay`: the command line that repeats the campaign, to which ` --only RUN` is added.
[[nodiscard]] std::string silent_run_text(const SilentRun& run, const std::string& replay);
// A page that opens without a network, in the style of the index of `armature check`.
[[nodiscard]] std::string campaign_page(const CampaignTable& table, const std::string& replay);
// A case for the runs without a fault and one for each kind. It fails if one of its runs is a silent error.
[[nodiscard]] std::vector<JunitCase> campaign_cases(const CampaignTable& table, const std::string& replay);

}  // namespace armature::cosim
