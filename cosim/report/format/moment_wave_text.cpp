#include "cosim/report/format/moment_wave_text.hpp"

#include <fmt/format.h>

#include "cosim/text/printable.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

MomentWaveText moment_wave_text(const MomentWaveResult& wave) {
  const std::string file = printable(wave.file, kShowAll);
  if (!wave.written())
    return {.label = "no waveform", .text = fmt::format("{} is not written: {}", file, wave.why_not)};
  return {.label = "waveform",
          .text = fmt::format("{}: {:.6f} s to {:.6f} s, of {} at {:.6f} s", file, to_seconds(wave.from),
                              to_seconds(wave.to), wave.moment, to_seconds(wave.at))};
}

}  // namespace armature::cosim
