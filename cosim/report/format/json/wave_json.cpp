#include "cosim/report/format/json/wave_json.hpp"

#include <utility>

#include "cosim/text/json.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

Json tick_json(const std::optional<std::int64_t>& tick) {
  return tick ? Json(*tick) : Json(nullptr);
}

Json difference_json(const WaveDifference& first) {
  const Cycles cycle = wave_cycle(first.at_ps);
  Json signals = Json::array();
  for (const auto& [signal, value_a, value_b] : first.signals) {
    signals.push_back({{"signal", signal.name + signal.range},
                       {"a", wave_value_text(signal, value_a)},
                       {"b", wave_value_text(signal, value_b)}});
  }
  return {{"cycle", cycle.value()},
          {"time_s", to_seconds(cycle)},
          {"tick_a", tick_json(first.tick_a)},
          {"tick_b", tick_json(first.tick_b)},
          {"signals", std::move(signals)}};
}

}  // namespace

Json wave_comparison_json(const WaveComparison& comparison) {
  return {{"equal", comparison.equal()},
          {"a", comparison.a},
          {"b", comparison.b},
          {"comparable", comparison.comparable()},
          {"from_cycle", wave_cycle(comparison.from_ps).value()},
          {"to_cycle", wave_cycle(comparison.to_ps).value()},
          {"signals", comparison.signals},
          {"signals_only_a", comparison.only_a},
          {"signals_only_b", comparison.only_b},
          {"first", comparison.first ? difference_json(*comparison.first) : Json(nullptr)}};
}

}  // namespace armature::cosim
