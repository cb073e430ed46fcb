#include "cosim/campaign/campaign_part.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <mutex>
#include <string>
#include <thread>

namespace armature::cosim {
namespace {

class PartRun {
 public:
  PartRun(const CampaignSpec& spec, const CampaignPart& part)
      : spec_{spec}, part_{part}, results_(part.groups.size()) {}

  // Takes groups until there are no more. An exception ends the work of all threads.
  void work(const std::filesystem::path& folder) {
    try {
      for (std::size_t i = next_++; i < part_.groups.size() && !part_.stop(); i = next_++) {
        results_[i] = run_group(spec_, part_.groups[i], folder, part_.wanted, part_.stop);
        count();
      }
    } catch (...) {
      const std::scoped_lock lock{mutex_};
      error_ = std::current_exception();
      next_ = part_.groups.size();
    }
  }

  [[nodiscard]] std::vector<CampaignResult> results() {
    if (error_) std::rethrow_exception(error_);
    std::vector<CampaignResult> all;
    for (std::vector<CampaignResult>& group : results_) std::ranges::move(group, std::back_inserter(all));
    return all;
  }

 private:
  void count() {
    const std::scoped_lock lock{mutex_};
    ++done_;
    if (part_.progress) part_.progress(done_);
  }

  const CampaignSpec& spec_;
  const CampaignPart& part_;
  std::vector<std::vector<CampaignResult>> results_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::exception_ptr error_;
};

}  // namespace

std::vector<CampaignResult> run_part(const CampaignSpec& spec, const CampaignPart& part,
                                     const std::filesystem::path& folder) {
  PartRun run{spec, part};
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < part.jobs; ++i) {
      helpers.emplace_back([&run, own = folder / std::to_string(i)] { run.work(own); });
    }
    run.work(folder / "0");
  }
  return run.results();
}

}  // namespace armature::cosim
