// Keys that several tables have.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/timebase.hpp"
#include "cosim/scenario/keys/key.hpp"
#include "cosim/scenario/pin_spec.hpp"

namespace armature::cosim {

inline constexpr double kMaxDurationS = 86'400;      // a day
inline constexpr double kCycleS = 1.0 / kClkFreqHz;  // what lasts for less can miss every edge of the clock
inline constexpr double kMaxCycles = 50'000'000;     // a second of the 50 MHz clock
inline constexpr double kMaxCount = 1'000'000'000;
inline constexpr double kMaxStreamDelayMs = 10'000;
inline constexpr double kMaxPlaceMm = 100'000;  // far beyond any arm; this only catches nonsense
inline constexpr double kMaxAngleDeg = 36'000;  // soft limits are the controller's business

// The message for a time that is not in the run; empty when it is.
[[nodiscard]] std::string outside_run(double at_s, const Scenario& scenario);
// Bytes of pairs of hexadecimal digits, or the message.
[[nodiscard]] std::string read_hex(const std::string& digits, std::string& bytes);
inline constexpr std::string_view kHexPattern = "^\\s*([0-9A-Fa-f]{2}\\s*)*$";

// `at_s`: every timed entry must happen during the run.
template <class Spec>
[[nodiscard]] Key<Spec> at_key(std::string_view text) {
  return key("at_s", &Spec::at_s, between(0, kMaxDurationS, "s"), text)
      .required()
      .checked([](Spec& spec, const KeyContext& context) { return outside_run(spec.at_s, *context.scenario); });
}

template <class Spec>
[[nodiscard]] Key<Spec> pin_key(std::string_view text) {
  return key("pin", &Spec::pin, between(1, kToolPins), text).required();
}

template <class Spec>
[[nodiscard]] Key<Spec> level_key(std::string_view text) {
  return set_key<Spec, std::int64_t>(
             "level",
             [](Spec& spec, std::int64_t bit) {
               spec.level = bit != 0;
               return std::string{};
             },
             between(0, 1), text)
      .required();
}

// Whether another table of the list has the same value of this key.
template <class Spec, class Value>
[[nodiscard]] bool is_taken(const std::vector<Spec>& all, const Spec& one, Value Spec::*key) {
  return std::ranges::any_of(all, [&](const Spec& other) { return &other != &one && other.*key == one.*key; });
}

}  // namespace armature::cosim
