// Leaves out of a failing case what it does not need to fail.
#pragma once

#include <filesystem>

#include "cosim/campaign/campaign.hpp"

namespace armature::cosim {

// The case with the fewest steps and faults that ends in the same silent error: no further step or fault can be left
// out alone. Its duration is what it needs.
[[nodiscard]] CampaignResult shrink(const CampaignSpec& spec, const CampaignResult& failing,
                                    const std::filesystem::path& folder);

}  // namespace armature::cosim
