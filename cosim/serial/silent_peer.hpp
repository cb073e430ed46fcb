// A peer that sends nothing, while the script of the line sends what others have sent before: a replay. It takes the
// place of the scripted pendant, whose bytes would come a second time.
#pragma once

#include "cosim/serial/serial_peer.hpp"

namespace armature::cosim {

class SilentPeer final : public SerialPeer {
 public:
  void exchange(Cycles, std::size_t, std::vector<std::uint8_t>&) override {}
  void send(std::uint8_t) override {}
};

}  // namespace armature::cosim
