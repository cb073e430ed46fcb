// A recorded run of arm_soc, clock by clock: the levels of all inputs before an edge and of all outputs after it.
//
// The text file has one line per clock, from the end of the reset. A line is one hexadecimal number of 8 * kWords
// digits. Its fields are, adjacent and from bit 0: inputs of the bus, input pins, outputs of the bus, output
// pins. Pins are in the order of the pin table. four_state.py uses the same layout.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "cosim/fabric/fabric.hpp"
#include "cosim/logic/pin_list.hpp"

namespace armature::test {

// Number of clocks in reset with idle inputs before the first line, as in make_verilated_fabric().
inline constexpr int kReplayResetCycles = 16;

// Calls visit(level, bits) for each field of the bus in the order of a line.
template <class Master, class Visit>
constexpr void visit_bus_inputs(Master& m, Visit visit) {
  visit(m.awaddr, 32), visit(m.wdata, 32), visit(m.araddr, 32), visit(m.wstrb, 4), visit(m.awvalid, 1);
  visit(m.wvalid, 1), visit(m.bready, 1), visit(m.arvalid, 1), visit(m.rready, 1);
}
template <class Slave, class Visit>
constexpr void visit_bus_outputs(Slave& s, Visit visit) {
  visit(s.rdata, 32), visit(s.bresp, 2), visit(s.rresp, 2), visit(s.awready, 1), visit(s.wready, 1), visit(s.bvalid, 1);
  visit(s.arready, 1), visit(s.rvalid, 1);
}

constexpr int bits_of_a_line() {
  int sum = 0;
  const auto add = [&sum](const auto&, int bits) { sum += bits; };
  const cosim::AxiMasterPins master;
  const cosim::AxiSlavePins slave;
  visit_bus_inputs(master, add);
  visit_bus_outputs(slave, add);
  for (const cosim::Pin& pin : cosim::kPins) sum += pin.bits;
  return sum;
}
inline constexpr std::size_t kWords = (bits_of_a_line() + 31) / 32;

// Bit 0 of the line is bit 0 of word 0.
using Vector = std::array<std::uint32_t, kWords>;

// Reads the fields of a vector one after the other.
class Cursor {
 public:
  void put(Vector& vector, std::uint32_t level, int bits) {
    const std::size_t word = at_ / 32, shift = at_ % 32;
    vector[word] |= level << shift;
    if (shift + static_cast<std::size_t>(bits) > 32) vector[word + 1] |= level >> (32 - shift);
    at_ += static_cast<std::size_t>(bits);
  }
  std::uint32_t take(const Vector& vector, int bits) {
    const std::size_t word = at_ / 32, shift = at_ % 32;
    std::uint64_t pair = vector[word];
    if (word + 1 < kWords) pair |= std::uint64_t{vector[word + 1]} << 32;
    at_ += static_cast<std::size_t>(bits);
    return static_cast<std::uint32_t>(pair >> shift) & ~0u >> (32 - bits);
  }

 private:
  std::size_t at_ = 0;
};

inline Vector pack(const cosim::SocInputs& in, const cosim::AxiMasterPins& m, const cosim::SocOutputs& out,
                   const cosim::AxiSlavePins& s) {
  Vector vector{};
  Cursor cursor;
  const auto put = [&](std::uint32_t level, int bits) { cursor.put(vector, level, bits); };
  const auto put_pins = [&](bool inputs) {
    for (const cosim::Pin& pin : cosim::kPins) {
      if (pin.is_input() == inputs) put(pin.get(in, out), pin.bits);
    }
  };
  visit_bus_inputs(m, put);
  put_pins(true);
  visit_bus_outputs(s, put);
  put_pins(false);
  return vector;
}

// The inputs of a vector.
inline void unpack(const Vector& vector, cosim::SocInputs& in, cosim::AxiMasterPins& m) {
  Cursor cursor;
  visit_bus_inputs(m, [&](auto& level, int bits) {
    level = static_cast<std::remove_reference_t<decltype(level)>>(cursor.take(vector, bits));
  });
  for (const cosim::Pin& pin : cosim::kPins) {
    if (pin.is_input()) pin.set(in, cursor.take(vector, pin.bits));
  }
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
    for (std::size_t i = kWords; i-- > 0;) std::fprintf(file_, "%08x", static_cast<unsigned>(vector[i]));
    std::fputc('\n', file_);
  }

  // Returns nothing at the end of the file.
  std::optional<Vector> read() {
    char line[kWords * 8 + 2];
    if (std::fgets(line, sizeof line, file_) == nullptr) return std::nullopt;
    Vector vector{};
    for (std::size_t i = 0; i < kWords; ++i) {
      vector[kWords - 1 - i] = static_cast<std::uint32_t>(std::stoul(std::string{line + i * 8, 8}, nullptr, 16));
    }
    return vector;
  }

 private:
  std::FILE* file_;
};

}  // namespace armature::test
