// The words of a waveform file in the form of VCD, in constant memory.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

// Whether the file is a waveform by its name: .vcd or .fst.
[[nodiscard]] bool is_wave_name(const std::filesystem::path& file);

class WaveInput {
 public:
  static constexpr std::size_t kLongestWord = std::size_t{1} << 17;  // bytes

  // A file .fst is read through the program fst2vcd (Debian package gtkwave), any other one as VCD. Throws InputError
  // when it cannot be opened, and when the program is missing.
  explicit WaveInput(const std::filesystem::path& file);
  ~WaveInput();
  WaveInput(const WaveInput&) = delete;
  WaveInput& operator=(const WaveInput&) = delete;

  // The next word, valid until the next call; empty at the end. Throws InputError when the file cannot be read.
  std::string_view word();
  // At the end: the file ends within a word, which was not returned.
  [[nodiscard]] bool ends_early() const { return ends_early_; }

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  bool fill();
  int close();

  std::string name_;
  bool pipe_ = false;
  std::FILE* stream_ = nullptr;
  std::vector<char> buffer_ = std::vector<char>(kLongestWord);
  std::size_t begin_ = 0, end_ = 0;  // of what was read and not returned
  bool ends_early_ = false;
};

}  // namespace armature::cosim
