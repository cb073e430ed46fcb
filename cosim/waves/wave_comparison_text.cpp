#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "controller/base/timebase.hpp"
#include "cosim/time/clock.hpp"
#include "cosim/waves/wave_compare.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kCyclePs = kNsPerCycle * 1'000;
constexpr std::size_t kMaxNamed = 8;  // signals in one list
constexpr int kNumberBits = 32;       // a longer signal of the software is a text
constexpr int kByteBits = 8;

std::string moment_text(std::int64_t ps) {
  const Cycles cycle = wave_cycle(ps);
  return fmt::format("cycle {} ({} s)", cycle.value(), seconds_text(cycle));
}

std::string ticks_text(const WaveDifference& first) {
  if (!first.tick_a || !first.tick_b) return "";
  if (first.tick_a == first.tick_b) return fmt::format(", tick {}", *first.tick_a);
  return fmt::format(", ticks {} and {}", *first.tick_a, *first.tick_b);
}

std::string only_in(const std::string& file, const std::vector<std::string>& names) {
  if (names.empty()) return "";
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i) list += (i == 0 ? "" : ", ") + names[i];
  return fmt::format("  {} {} only in {}: {}{}\n", names.size(), names.size() == 1 ? "signal" : "signals", file, list,
                     names.size() > kMaxNamed ? ", ..." : "");
}

std::string differing_signals(const WaveComparison& comparison) {
  const std::vector<SignalDifference>& signals = comparison.first->signals;
  std::string text;
  for (std::size_t i = 0; i < std::min(signals.size(), kMaxNamed); ++i) {
    const auto& [signal, value_a, value_b] = signals[i];
    text += fmt::format("  {}{}: {}: {}, {}: {}\n", signal.name, signal.range, comparison.a,
                        wave_value_text(signal, value_a), comparison.b, wave_value_text(signal, value_b));
  }
  if (signals.size() > kMaxNamed) text += fmt::format("  and {} more signals\n", signals.size() - kMaxNamed);
  return text;
}

// Four digits at a time from the right.
std::string hex_text(std::string digits) {
  constexpr std::size_t kBitsOfDigit = 4;
  digits.insert(0, (kBitsOfDigit - digits.size() % kBitsOfDigit) % kBitsOfDigit, '0');
  std::string text = "0x";
  for (std::size_t at = 0; at < digits.size(); at += kBitsOfDigit) {
    int value = 0;
    for (std::size_t i = at; i < at + kBitsOfDigit; ++i) value = 2 * value + (digits[i] == '1' ? 1 : 0);
    text += fmt::format("{:X}", value);
  }
  return text;
}

// ASCII, without what is not printable.
std::string software_text(std::string digits) {
  digits.insert(0, (kByteBits - digits.size() % kByteBits) % kByteBits, '0');
  std::string text = "'";
  for (std::size_t at = 0; at < digits.size(); at += kByteBits) {
    char c = 0;
    for (std::size_t i = at; i < at + kByteBits; ++i) c = static_cast<char>(2 * c + (digits[i] == '1' ? 1 : 0));
    if (c != 0) text += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '?';
  }
  return text + "'";
}

}  // namespace

Cycles wave_cycle(std::int64_t ps) {
  return Cycles{ps / kCyclePs};
}

bool is_wave_text(const WaveSignal& signal) {
  return signal.bits > kNumberBits && signal.name.starts_with("top.software.");
}

std::string wave_value_text(const WaveSignal& signal, const std::string& value) {
  if (value.find_first_not_of("01") != std::string::npos) return value;
  if (is_wave_text(signal)) return software_text(value);
  return signal.bits == 1 ? value : hex_text(value);
}

std::string WaveComparison::report() const {
  if (signals == 0) return fmt::format("FAIL {} and {} have no signal in common\n", a, b);
  if (!begin_a_ps || !begin_b_ps) {
    return fmt::format("FAIL {} and {} have no time in common\n  {} has none\n", a, b, begin_a_ps ? b : a);
  }
  if (!common_time) {
    const bool a_ends = *begin_a_ps < *begin_b_ps;
    return fmt::format("FAIL {} and {} have no time in common\n  {} ends in {}, {} begins in {}\n", a, b,
                       a_ends ? a : b, moment_text(to_ps), a_ends ? b : a, moment_text(from_ps));
  }
  const std::string others = only_in(a, only_a) + only_in(b, only_b);
  if (!first) {
    return fmt::format("PASS {} and {} are equal: {} signals from {} to {}\n", a, b, signals, moment_text(from_ps),
                       moment_text(to_ps)) +
           others;
  }
  return fmt::format("FAIL {} and {} differ first in {}{}\n", a, b, moment_text(first->at_ps), ticks_text(*first)) +
         differing_signals(*this) +
         fmt::format("  {} signals were compared from {} on\n", signals, moment_text(from_ps)) + others;
}

}  // namespace armature::cosim
