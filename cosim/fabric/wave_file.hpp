// Output of a waveform: a VCD file, or an FST file through the program vcd2fst (Debian package gtkwave). A verilated
// model supports one format per build; the converter avoids a second model.
#pragma once

#include <verilated_vcd_c.h>

#include <cstdint>
#include <cstdio>
#include <string>

#include "controller/base/timebase.hpp"
#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

inline constexpr std::uint64_t kCycleNs = 1'000'000'000 / kClkFreqHz;  // duration of a cycle in a waveform

class WaveFile final : public VerilatedVcdFile {
 public:
  ~WaveFile() override { close(); }

  // Format of the next open().
  void set_format(WaveFormat format) { format_ = format; }

  bool open(const std::string& name) override;
  void close() override;
  ssize_t write(const char* data, ssize_t bytes) override;

  // Error of the last file, valid after close(); empty when there was none.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  WaveFormat format_ = WaveFormat::kVcd;
  std::FILE* file_ = nullptr;
  bool pipe_ = false;
  std::string name_;
  std::string error_;
};

}  // namespace armature::cosim
