#include "cosim/campaign/campaign_part.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <string>

#include "cosim/run/parallel.hpp"

namespace armature::cosim {

std::vector<CampaignResult> run_part(const CampaignSpec& spec, const CampaignPart& part,
                                     const std::filesystem::path& folder) {
  std::vector<std::vector<CampaignResult>> results(part.groups.size());
  std::mutex mutex;
  std::size_t done = 0;
  for_each_in_parallel(results.size(), part.jobs, [&](std::size_t i, int thread) {
    if (part.stop()) return false;
    results[i] = run_group(spec, part.groups[i], folder / std::to_string(thread), part.wanted, part.stop);
    const std::scoped_lock lock{mutex};
    ++done;
    if (part.progress) part.progress(done);
    return true;
  });
  std::vector<CampaignResult> all;
  for (std::vector<CampaignResult>& group : results) std::ranges::move(group, std::back_inserter(all));
  return all;
}

}  // namespace armature::cosim
