// Reads a waveform from one time to the next.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/waves/wave_codes.hpp"
#include "cosim/waves/wave_input.hpp"

namespace armature::cosim {

struct WaveSignal {
  std::string name;   // with its scopes: top.arm_soc.step_o
  std::string range;  // of its bits, as [5:0]; empty: one bit
  int bits = 0;
  std::uint32_t value = 0;  // number of its value in the reader; names of one signal share it
};

class WaveReader {
 public:
  // Reads the declarations. Throws InputError, as next() does, when the file cannot be read or is no waveform.
  explicit WaveReader(const std::filesystem::path& file);

  [[nodiscard]] const std::string& file() const { return input_.name(); }
  // In the order of the file.
  [[nodiscard]] const std::vector<WaveSignal>& signals() const { return signals_; }
  [[nodiscard]] std::uint32_t values() const { return codes_.size(); }
  // The unit in which the file gives times.
  [[nodiscard]] std::int64_t unit_ps() const { return unit_ps_; }

  // The time of the coming next(), in ps; none: there is no further one.
  [[nodiscard]] std::optional<std::int64_t> next_ps() const { return next_ps_; }
  // Reads the changes at next_ps(). Returns false when the file ends within them: they are not valid then.
  bool next();

  // The time of the last next() that succeeded, in ps. Call these after it.
  [[nodiscard]] std::int64_t now_ps() const { return now_ps_; }
  // What has changed in it: numbers of values, one of them perhaps several times.
  [[nodiscard]] const std::vector<std::uint32_t>& changed() const { return changed_; }
  // Binary digits without zeros in front, as `101`; `x` if nothing is known. A real number or a text has its letter of
  // VCD in front.
  [[nodiscard]] const std::string& value(std::uint32_t number) const { return values_[number]; }

 private:
  void read_declarations();
  void declare_signal(const std::string& scope);
  void read_timescale();
  void read_first_time();
  bool read_change(std::string_view word);
  void read_time(std::string_view digits);
  void set_next(std::string_view value);
  void set(std::string_view code, std::string_view value);
  void skip_section();
  std::string_view declaration_word();
  [[noreturn]] void refuse(std::string_view expected, std::string_view found) const;

  WaveInput input_;
  WaveCodes codes_;
  std::vector<WaveSignal> signals_;
  std::vector<std::string> values_;
  std::vector<std::uint32_t> changed_;
  std::string word_;  // that is kept while the next one is read
  std::int64_t unit_ps_ = 1;
  std::int64_t now_ps_ = 0;
  std::optional<std::int64_t> next_ps_;
  bool ends_early_ = false;  // within the change of a value
};

}  // namespace armature::cosim
