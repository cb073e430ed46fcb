#include "cosim/waves/wave_compare.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kTickSignal = "top.software.tick";
// They are empty until the first access after the waveform was opened.
constexpr std::string_view kLatestAccess = "top.software.bus_";

constexpr std::int64_t kNeverPs = std::numeric_limits<std::int64_t>::max();

std::string full_name(const WaveSignal& signal) {
  return signal.name + signal.range;
}

// One signal of both files.
struct SignalPair {
  WaveSignal a;
  std::uint32_t value_b = 0;
  bool waits = false;  // it is not compared yet
};

class WaveComparer {
 public:
  WaveComparer(const std::filesystem::path& a, const std::filesystem::path& b) : a_{a}, b_{b} {
    result_.a = a_.file();
    result_.b = b_.file();
    result_.unit_a_ps = a_.unit_ps();
    result_.unit_b_ps = b_.unit_ps();
    pair_signals();
  }

  WaveComparison compare() {
    if (result_.signals > 0 && go_to_common_time()) {
      compare_all();
      while (differing_.empty() && step()) {
      }
      note_difference();
    }
    return std::move(result_);
  }

 private:
  void pair_signals() {
    std::unordered_map<std::string, const WaveSignal*> of_b;
    for (const WaveSignal& signal : b_.signals()) of_b.emplace(full_name(signal), &signal);
    std::set<std::pair<std::uint32_t, std::uint32_t>> paired;
    pairs_of_a_.resize(a_.values());
    pairs_of_b_.resize(b_.values());
    std::set<std::string> names_a;
    for (const WaveSignal& signal : a_.signals()) {
      const std::string name = full_name(signal);
      names_a.insert(name);
      const auto twin = of_b.find(name);
      if (twin == of_b.end()) {
        result_.only_a.push_back(name);
        continue;
      }
      ++result_.signals;
      const std::uint32_t value_b = twin->second->value;
      if (!paired.emplace(signal.value, value_b).second) continue;
      pairs_of_a_[signal.value].push_back(pairs_.size());
      pairs_of_b_[value_b].push_back(pairs_.size());
      pairs_.push_back({signal, value_b});
    }
    for (const WaveSignal& signal : b_.signals()) {
      if (const std::string name = full_name(signal); !names_a.contains(name)) result_.only_b.push_back(name);
    }
  }

  // To the later one of the two first times. Returns false when one file has ended by then.
  bool go_to_common_time() {
    result_.begin_a_ps = a_.next_ps();
    result_.begin_b_ps = b_.next_ps();
    result_.common_time = false;
    if (!result_.begin_a_ps || !result_.begin_b_ps) return false;
    result_.from_ps = std::max(*result_.begin_a_ps, *result_.begin_b_ps);
    return result_.common_time = reach(a_) && reach(b_);
  }

  bool reach(WaveReader& file) {
    while (file.next_ps() && *file.next_ps() <= result_.from_ps && file.next()) {
    }
    result_.to_ps = file.now_ps();
    return file.next_ps() || file.now_ps() == result_.from_ps;
  }

  void compare_all() {
    result_.to_ps = result_.from_ps;
    const bool one_is_later = result_.begin_a_ps != result_.begin_b_ps;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (!differs(pairs_[i])) continue;
      pairs_[i].waits = one_is_later && pairs_[i].a.name.starts_with(kLatestAccess);
      if (!pairs_[i].waits) differing_.insert(i);
    }
  }

  // The next time of either file. Returns false at the end of the common part.
  bool step() {
    const std::optional<std::int64_t> next_a = a_.next_ps(), next_b = b_.next_ps();
    if (!next_a && !next_b) return false;
    const std::int64_t at_ps = std::min(next_a.value_or(kNeverPs), next_b.value_or(kNeverPs));
    if (!next_a && at_ps > a_.now_ps()) return false;
    if (!next_b && at_ps > b_.now_ps()) return false;
    const bool with_a = next_a == at_ps, with_b = next_b == at_ps;
    if (with_a && !a_.next()) return false;
    if (with_b && !b_.next()) return false;
    result_.to_ps = at_ps;
    if (with_a) compare_changed(a_, pairs_of_a_, result_.begin_a_ps > result_.begin_b_ps);
    if (with_b) compare_changed(b_, pairs_of_b_, result_.begin_b_ps > result_.begin_a_ps);
    return true;
  }

  void compare_changed(const WaveReader& file, const std::vector<std::vector<std::size_t>>& pairs_of, bool is_later) {
    for (const std::uint32_t value : file.changed()) {
      for (const std::size_t i : pairs_of[value]) {
        SignalPair& pair = pairs_[i];
        const bool differ = differs(pair);
        if (is_later || !differ) pair.waits = false;
        if (differ && !pair.waits) differing_.insert(i);
      }
    }
  }

  [[nodiscard]] bool differs(const SignalPair& pair) const { return a_.value(pair.a.value) != b_.value(pair.value_b); }

  void note_difference() {
    if (differing_.empty()) return;
    WaveDifference& first = result_.first.emplace();
    first.at_ps = result_.to_ps;
    first.tick_a = tick_of(a_);
    first.tick_b = tick_of(b_);
    for (const std::size_t i : differing_) {
      const SignalPair& pair = pairs_[i];
      first.signals.push_back({pair.a, a_.value(pair.a.value), b_.value(pair.value_b)});
    }
  }

  static std::optional<std::int64_t> tick_of(const WaveReader& file) {
    const auto found = std::ranges::find(file.signals(), kTickSignal, &WaveSignal::name);
    if (found == file.signals().end()) return std::nullopt;
    const auto bits = parsed_number<std::uint32_t>(file.value(found->value), 2);
    if (!bits) return std::nullopt;
    return static_cast<std::int32_t>(*bits);
  }

  WaveReader a_, b_;
  WaveComparison result_;
  std::vector<SignalPair> pairs_;                                  // in the order of file a
  std::vector<std::vector<std::size_t>> pairs_of_a_, pairs_of_b_;  // by the number of the value
  std::set<std::size_t> differing_;                                // numbers of pairs
};

}  // namespace

WaveComparison compare_waves(const std::filesystem::path& a, const std::filesystem::path& b) {
  return WaveComparer{a, b}.compare();
}

}  // namespace armature::cosim
