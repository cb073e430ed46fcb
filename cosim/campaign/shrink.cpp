#include "cosim/campaign/shrink.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

std::optional<CampaignResult> still_fails(const CampaignSpec& spec, const CampaignCase& drawn, Outcome outcome,
                                          const std::filesystem::path& folder) {
  try {
    CampaignResult result = run_case(spec, drawn, folder);
    if (result.verdict.outcome != outcome) return std::nullopt;
    // With faults, an error of the moves alone is another one.
    if (!drawn.faults.empty() && result.faults.empty()) return std::nullopt;
    return result;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

CampaignResult shrink(const CampaignSpec& spec, const CampaignResult& failing, const std::filesystem::path& folder) {
  CampaignResult least = failing;
  // All but the first and the last ones.
  const auto leave_out = [&](std::vector<std::string> CampaignCase::*parts, std::size_t first, std::size_t last) {
    bool any = false;
    for (std::size_t i = (least.drawn.*parts).size() - last; i-- > first;) {
      CampaignCase fewer = least.drawn;
      (fewer.*parts).erase((fewer.*parts).begin() + static_cast<std::ptrdiff_t>(i));
      if (std::optional<CampaignResult> still = still_fails(spec, fewer, failing.verdict.outcome, folder)) {
        const std::int64_t run = least.run;
        least = *std::move(still);
        least.run = run;
        any = true;
      }
    }
    return any;
  };
  while (leave_out(&CampaignCase::faults, 0, 0) || leave_out(&CampaignCase::steps, kFirstSteps, kLastSteps)) {
  }
  return least;
}

}  // namespace armature::cosim
