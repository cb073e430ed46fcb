// Opens and closes the waveform file for a window of simulated time.
#pragma once

#include <filesystem>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/soc/soc.hpp"

namespace armature::cosim {

struct WaveRequest {
  std::filesystem::path file;
  WaveFormat format = WaveFormat::kVcd;
  std::optional<Cycles> from;  // default: cycle 0
  std::optional<Cycles> to;    // default: the end of the run
};

class WaveWindow {
 public:
  explicit WaveWindow(std::optional<WaveRequest> request);

  // The next cycle at which advance() must be called.
  [[nodiscard]] std::optional<Cycles> next_event() const;

  // Opens or closes the file when it is due at `now`.
  void advance(Cycles now, Soc& soc);

  [[nodiscard]] bool is_open() const { return state_ == State::kOpen; }
  // Whether the file was ever opened.
  [[nodiscard]] bool was_open() const { return was_open_; }

 private:
  enum class State { kDone, kWaiting, kOpen };

  WaveRequest request_;
  State state_ = State::kDone;
  bool was_open_ = false;
};

}  // namespace armature::cosim
