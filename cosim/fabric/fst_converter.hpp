// FST waveforms are made by the program vcd2fst of Debian's package gtkwave.
#pragma once

namespace armature::cosim {

// Whether the program is installed. Call it before a long run.
[[nodiscard]] bool fst_converter_available();

}  // namespace armature::cosim
