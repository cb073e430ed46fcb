// The values of the software's signals in a waveform: those of software_signals.toml, scope `top.software`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cosim/fabric/software_signal_list.hpp"

namespace armature::cosim {

class SoftwareSignals {
 public:
  // A signal of at most 32 bits. The highest bits of `value` are left out.
  void set(SoftwareSignal signal, std::uint32_t value) { words_[row(signal).word] = value; }
  // A text. Its end is left out if it does not fit.
  void set(SoftwareSignal signal, std::string_view text);
  // Of the longest text that fits.
  [[nodiscard]] static constexpr std::size_t characters(SoftwareSignal signal) {
    return static_cast<std::size_t>(row(signal).bits) / kCharacterBits;
  }

  // The words of a signal, the lowest bits first.
  [[nodiscard]] const std::uint32_t* words(const SoftwareSignalRow& row) const { return &words_[row.word]; }

 private:
  static constexpr std::size_t kCharacterBits = 8;

  [[nodiscard]] static constexpr const SoftwareSignalRow& row(SoftwareSignal signal) {
    return kSoftwareSignals[static_cast<std::size_t>(signal)];
  }

  std::array<std::uint32_t, kSoftwareWords> words_{};
};

}  // namespace armature::cosim
