#include "cosim/rewind/wave_span.hpp"

#include <algorithm>

#include "controller/base/timebase.hpp"

namespace armature::cosim {

Cycles write_span(Run& run, const WaveSpan& span, const WaveOutput& output,
                  const std::function<bool()>& stop_requested) {
  run.write_wave({.file = output.file, .format = output.format, .from = span.from, .to = span.to});
  bool continues = true;
  while (continues && run.now() < span.to && !stop_requested()) {
    continues = run.advance(std::min(run.now() + armature::kTickCycles, span.to));
  }
  run.close_wave();
  return run.now();
}

}  // namespace armature::cosim
