#include "cosim/fabric/software_signals.hpp"

#include <algorithm>

namespace armature::cosim {
namespace {

constexpr std::size_t kCharactersOfWord = 4;

}  // namespace

void SoftwareSignals::set(SoftwareSignal signal, std::string_view text) {
  const SoftwareSignalRow& of = row(signal);
  const std::size_t words = (characters(signal) + kCharactersOfWord - 1) / kCharactersOfWord;
  text = text.substr(0, characters(signal));
  std::fill_n(words_.begin() + static_cast<std::ptrdiff_t>(of.word), words, 0u);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto character = static_cast<unsigned char>(text[text.size() - 1 - i]);
    words_[of.word + i / kCharactersOfWord] |= std::uint32_t{character} << (kCharacterBits * (i % kCharactersOfWord));
  }
}

}  // namespace armature::cosim
