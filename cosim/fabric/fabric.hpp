// The programmable logic as the rest of the simulation sees it: pins in, pins out, one AXI4-Lite port, one clock.
//
// The verilated RTL is one implementation; nothing outside cosim/fabric may assume which one runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "controller/core/units.hpp"

namespace armature::cosim {

// Levels that the surroundings drive. One bit per axis, axis 1 = bit 0. Sampled by the next rising clock edge.
struct FabricInputs {
  std::uint8_t enc_a = 0;
  std::uint8_t enc_b = 0;
  std::uint8_t enc_z = 0;
  std::uint8_t home = 0;
  std::uint8_t limit_pos = 0;
  std::uint8_t limit_neg = 0;
  std::uint8_t drive_alarm = 0;
  std::uint8_t in_position = 0;
  bool estop_n = true;        // active low
  bool uart_rxd = true;       // serial line to the UART, idle high
  bool capture_trig = false;  // both timers capture on its rising edge
  std::uint16_t gpio = 0;     // inputs of the tool
  friend bool operator==(const FabricInputs&, const FabricInputs&) = default;
};

// Registered levels that the logic drives, valid after each clock edge.
struct FabricOutputs {
  std::uint8_t step = 0;
  std::uint8_t dir = 0;
  std::uint8_t servo_on = 0;
  bool trigger = false;  // one cycle per tick, the edge on which counts become active and positions are snapshotted
  std::uint8_t irq = 0;  // level interrupts, bit as in soc_map.toml
  bool uart_txd = true;  // serial line from the UART, idle high
  bool pwm = false;
  std::uint16_t gpio = 0;  // outputs to the tool
  friend bool operator==(const FabricOutputs&, const FabricOutputs&) = default;
};

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

// Thrown by run() when a check inside the logic fails; its message has been printed.
struct FabricCheckFailed {
  Cycles cycle;
};

enum class WaveFormat : std::uint8_t { kVcd, kFst };

// A waveform file that could not be written, or not completely.
struct WaveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Fabric {
 public:
  virtual ~Fabric() = default;

  // Levels for the coming clock edges, until the next call.
  virtual void set_inputs(const FabricInputs& inputs) = 0;
  virtual void set_master(const AxiMasterPins& pins) = 0;

  // Runs at most `limit` (at least 1) clock edges and stops after the first on which an output pin changed.
  // Returns true when one did.
  virtual bool run(std::int64_t limit) = 0;

  // Values after the last edge.
  [[nodiscard]] virtual const FabricOutputs& outputs() const = 0;
  [[nodiscard]] virtual AxiSlavePins slave() const = 0;

  // Clock edges since reset was released.
  [[nodiscard]] virtual Cycles cycle() const = 0;

  // Writes every signal to a waveform file from now on, one file at a time. Both throw WaveError.
  virtual void open_wave(const std::filesystem::path& file, WaveFormat format) = 0;
  virtual void close_wave() = 0;
};

}  // namespace armature::cosim
