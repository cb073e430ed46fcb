// The AXI4-Lite master port of the processing system: independent AW, W, B, AR and R channels, one transaction at a
// time, a fixed latency on the processing-system side each way, optional seeded stalls, response checks, time-outs.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/units.hpp"
#include "cosim/bus/bus_access.hpp"
#include "cosim/bus/bus_spec.hpp"
#include "cosim/fabric/fabric.hpp"
#include "cosim/time/random.hpp"

namespace armature::cosim {

class AxiLiteMaster {
 public:
  AxiLiteMaster(const BusSpec& spec, std::uint64_t seed);

  // Starts a transaction at clock cycle `now`; the port must be idle().
  void start(const BusRequest& request, Cycles now);

  [[nodiscard]] bool idle() const { return phase_ == Phase::kIdle; }

  // The cycle at which step() must be called next; valid only while not idle. During the handshakes this is every
  // cycle.
  [[nodiscard]] Cycles next_event() const { return next_event_; }

  // Advances to `now`, after the clock edge of that cycle. `slave` are the slave's pins after that edge. Returns the
  // response in the cycle in which the core receives it.
  std::optional<BusResponse> step(Cycles now, const AxiSlavePins& slave);

  // The clock of the logic stood still for this time, which is no delay of the slave.
  void stood_still(Cycles time) { started_ += time; }

  // Pins for the coming edge.
  [[nodiscard]] const AxiMasterPins& pins() const { return pins_; }

 private:
  enum class Phase : std::uint8_t { kIdle, kRequestLatency, kHandshakes, kResponseLatency };

  void record_transfers();
  void drive_channels();
  bool stalled();

  BusSpec spec_;
  Random random_;
  Phase phase_ = Phase::kIdle;
  BusRequest request_;
  BusResponse response_;
  Cycles next_event_{};
  Cycles started_{};
  AxiMasterPins pins_;
  AxiSlavePins before_;  // slave pins before the edge; they decide which transfers happen on it
  bool addr_done_ = false;
  bool data_done_ = false;
  bool response_done_ = false;
};

}  // namespace armature::cosim
