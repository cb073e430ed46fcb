// A recorded run of arm_soc, clock by clock: the levels of all inputs before an edge and of all outputs after it.
//
// A text file with one line per clock from the end of the reset on: kWords words of 8 hexadecimal digits, most
// significant first, without blanks. replay_tb.sv unpacks the same layout.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "cosim/fabric/fabric.hpp"

namespace armature::test {

inline constexpr int kWords = 10;
inline constexpr int kFirstOutputWord = 7;
// Clocks in reset with idle inputs before the first line, as make_verilated_fabric() spends them.
inline constexpr int kReplayResetCycles = 16;

using Vector = std::array<std::uint32_t, kWords>;

inline Vector pack(const cosim::FabricInputs& in, const cosim::AxiMasterPins& m, const cosim::FabricOutputs& out,
                   const cosim::AxiSlavePins& s) {
  const auto bit = [](bool level, int position) { return std::uint32_t{level} << position; };
  const auto axes = [](std::uint8_t levels, int position) { return std::uint32_t{levels} << position; };
  return {
      m.awaddr,
      m.wdata,
      m.araddr,
      bit(m.awvalid, 0) | bit(m.wvalid, 1) | bit(m.bready, 2) | bit(m.arvalid, 3) | bit(m.rready, 4) | axes(m.wstrb, 8),
      axes(in.enc_a, 0) | axes(in.enc_b, 6) | axes(in.enc_z, 12) | axes(in.home, 18) | axes(in.limit_pos, 24),
      axes(in.limit_neg, 0) | axes(in.drive_alarm, 6) | axes(in.in_position, 12) | bit(in.estop_n, 18) |
          bit(in.uart_rxd, 19) | bit(in.capture_trig, 20),
      in.gpio,
      s.rdata,
      bit(s.awready, 0) | bit(s.wready, 1) | bit(s.bvalid, 2) | bit(s.arready, 3) | bit(s.rvalid, 4) |
          axes(s.bresp, 8) | axes(s.rresp, 10) | std::uint32_t{out.gpio} << 16,
      axes(out.step, 0) | axes(out.dir, 6) | axes(out.servo_on, 12) | bit(out.trigger, 18) | bit(out.uart_txd, 19) |
          bit(out.pwm, 20) | axes(out.irq, 24)};
}

class VectorFile {
 public:
  // "r" or "w". Throws std::runtime_error if the file cannot be opened.
  VectorFile(const std::filesystem::path& path, const char* mode) : file_{std::fopen(path.c_str(), mode)} {
    if (file_ == nullptr) throw std::runtime_error("cannot open " + path.string());
  }
  VectorFile(const VectorFile&) = delete;
  VectorFile& operator=(const VectorFile&) = delete;
  ~VectorFile() { std::fclose(file_); }

  void write(const Vector& vector) {
    for (const std::uint32_t word : vector) std::fprintf(file_, "%08x", static_cast<unsigned>(word));
    std::fputc('\n', file_);
  }

  // Nothing at the end of the file.
  std::optional<Vector> read() {
    char line[kWords * 8 + 2];
    if (std::fgets(line, sizeof line, file_) == nullptr) return std::nullopt;
    Vector vector{};
    for (int i = 0; i < kWords; ++i) {
      vector[static_cast<std::size_t>(i)] =
          static_cast<std::uint32_t>(std::stoul(std::string{line + i * 8, 8}, nullptr, 16));
    }
    return vector;
  }

 private:
  std::FILE* file_;
};

}  // namespace armature::test
