// Interface of the programmable logic: input pins, output pins, one AXI4-Lite port, one clock.
//
// The verilated RTL is one implementation. Code outside cosim/fabric must not assume which one runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/fabric/flops/flop.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/logic/pins.hpp"

namespace armature::cosim {

// The five AXI4-Lite channels, master side driven by the bus master, slave side by the fabric.
struct AxiMasterPins {
  std::uint32_t awaddr = 0, wdata = 0, araddr = 0;
  std::uint8_t wstrb = 0;
  bool awvalid = false, wvalid = false, bready = false, arvalid = false, rready = false;
};
struct AxiSlavePins {
  std::uint32_t rdata = 0;
  std::uint8_t bresp = 0, rresp = 0;
  bool awready = false, wready = false, bvalid = false, arready = false, rvalid = false;
};

// Thrown by run() when a check inside the logic fails. The message of the check has been printed.
struct LogicCheckFailed {
  Cycles cycle;
};

// Thrown by run() of fabrics in lock-step.
struct EnginesDiffer {
  Cycles cycle;
  std::string what;  // the pin and both values
};

class SoftwareSignals;

enum class WaveFormat : std::uint8_t { kVcd, kFst };

// A waveform file that could not be written, or not completely.
struct WaveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Fabric {
 public:
  virtual ~Fabric() = default;

  // Levels for the coming clock edges, until the next call.
  virtual void set_inputs(const SocInputs& inputs) = 0;
  virtual void set_master(const AxiMasterPins& pins) = 0;

  // Runs at most `limit` (at least 1) clock edges and stops after the first on which an output pin changed.
  // Returns true when one did.
  virtual bool run(std::int64_t limit) = 0;

  // Lets the time of `cycles` pass without a clock edge: cycle() grows, the logic stays as it is.
  virtual void stand_still(std::int64_t cycles) = 0;

  // Leaves out every further edge of the gated clock of these blocks, also the edges that they need.
  virtual void stop_clock_of(ClockGroup group) = 0;

  // The registers of the logic, if the fabric has any (flops/flops.hpp).
  [[nodiscard]] virtual std::vector<Flop> flops() { return {}; }
  // Inverts a bit of a register before the next edge. The gated clocks go on as active_o says: a block that rests keeps
  // the bit until it gets an edge. Returns false, and does nothing, if there is no such bit.
  virtual bool flip(std::string_view /*flop*/, int /*bit*/) { return false; }
  // Of the values of all registers, and of all changes of output pins so far. Call it only if there are flops().
  [[nodiscard]] virtual std::uint64_t digest() { return 0; }

  // Values after the last edge.
  [[nodiscard]] virtual const SocOutputs& outputs() const = 0;
  [[nodiscard]] virtual AxiSlavePins slave() const = 0;

  // Clock edges since reset was released.
  [[nodiscard]] virtual Cycles cycle() const = 0;

  // The waveforms also have these signals, with the values that they have at each edge. Call it before the first
  // waveform. They must outlive the fabric. Without waveforms it has no effect.
  virtual void add_to_waves(const SoftwareSignals&) {}
  // Writes every signal to a waveform file from now on, one file at a time. Both throw WaveError.
  virtual void open_wave(const std::filesystem::path& file, WaveFormat format) = 0;
  virtual void close_wave() = 0;
};

}  // namespace armature::cosim
