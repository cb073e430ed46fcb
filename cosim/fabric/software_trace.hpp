// Adds the signals of the software to a waveform.
#pragma once

#include <verilated_vcd_c.h>

#include <cstdint>
#include <string>
#include <utility>

#include "cosim/fabric/software_signals.hpp"

namespace armature::cosim {

class SoftwareTrace {
 public:
  // `scope`: of the signals, with a blank between its parts.
  explicit SoftwareTrace(std::string scope) : scope_{std::move(scope)} {}
  SoftwareTrace(const SoftwareTrace&) = delete;
  SoftwareTrace& operator=(const SoftwareTrace&) = delete;

  // Call it once, before `vcd` opens its first file. Both references must outlive `vcd`.
  void add_to(VerilatedVcdC& vcd, const SoftwareSignals& signals);

 private:
  static void declare(void* self, VerilatedVcd* vcd, std::uint32_t code);
  static void write_all(void* self, VerilatedVcd::Buffer* buffer);
  static void write_changes(void* self, VerilatedVcd::Buffer* buffer);
  void write(VerilatedVcd::Buffer& buffer, bool all) const;  // otherwise only what has changed

  std::string scope_;
  const SoftwareSignals* signals_ = nullptr;
  std::uint32_t code_ = 0;  // of the first word
};

}  // namespace armature::cosim
