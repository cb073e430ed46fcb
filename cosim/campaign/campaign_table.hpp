// The results of a campaign as counts by kind of fault.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cosim/campaign/campaign.hpp"
#include "cosim/campaign/judge/outcome.hpp"
#include "cosim/campaign/judge/outcome_counts.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

// Of the runs in which this kind is the only fault, and of those in which it is one of several.
struct KindRow {
  OutcomeCounts alone{}, with_others{};
  LatencyCounts latencies{};  // of `alone`
};

struct SilentRun {
  std::int64_t run = 0;
  Outcome outcome = Outcome::kFailed;
  std::vector<std::string> kinds{}, faults{};
  std::string reason{};
};

// What the results depend on, and which runs a table has.
struct CampaignHead {
  std::uint64_t seed = 1;
  std::int64_t runs = 0;  // of the whole campaign
  std::string engine{};
  std::vector<std::string> robots{};
  std::vector<std::string> only_kinds{};  // empty: faults of all kinds
  friend bool operator==(const CampaignHead&, const CampaignHead&) = default;
};

struct CampaignTable {
  CampaignHead head{};
  std::vector<std::string> shards{};       // `0/4`, if there are several
  std::int64_t done = 0;                   // runs in the table
  OutcomeCounts all{};                     // each run once
  OutcomeCounts without{};                 // of runs without a fault
  std::map<std::string, KindRow> kinds{};  // by the name of the kind
  std::vector<SilentRun> silent{};         // in the order of the runs

  void add(const CampaignResult& result);
  // Throws InputError if the tables are not of one campaign, or have the same shard. `file` is for the message.
  void merge(const CampaignTable& other, const std::string& file);
  [[nodiscard]] bool is_complete() const { return done == head.runs; }
};

[[nodiscard]] Json to_json(const CampaignTable& table);
// Throws InputError.
[[nodiscard]] CampaignTable campaign_table(const std::string& text, const std::string& file);

}  // namespace armature::cosim
