// Waveforms of logic that has no verilated model: the pins of arm_soc, scope `top.arm_soc`, and the software.
#pragma once

#include <verilated_vcd_c.h>

#include <cstdint>
#include <filesystem>

#include "cosim/fabric/fabric.hpp"
#include "cosim/fabric/software_trace.hpp"
#include "cosim/fabric/wave_file.hpp"
#include "cosim/logic/pins.hpp"

namespace armature::cosim {

class PinTrace {
 public:
  PinTrace();
  ~PinTrace();
  PinTrace(const PinTrace&) = delete;
  PinTrace& operator=(const PinTrace&) = delete;

  void add(const SoftwareSignals& signals) { software_.add_to(vcd_, signals); }  // see Fabric::add_to_waves()
  // One file at a time. Both throw WaveError.
  void open(const std::filesystem::path& file, WaveFormat format);
  void close();
  [[nodiscard]] bool is_open() const { return vcd_.isOpen(); }

  // The levels at a clock edge: the inputs that it sees, the outputs after it.
  void dump(Cycles cycle, const SocInputs& inputs, const SocOutputs& outputs);

 private:
  static void declare(void* self, VerilatedVcd* vcd, std::uint32_t code);
  static void write_all(void* self, VerilatedVcd::Buffer* buffer);
  static void write_changes(void* self, VerilatedVcd::Buffer* buffer);

  SocInputs inputs_;
  SocOutputs outputs_;
  std::uint32_t code_ = 0;  // of the first pin
  WaveFile file_;
  SoftwareTrace software_{"top software"};
  VerilatedVcdC vcd_{&file_};
};

}  // namespace armature::cosim
