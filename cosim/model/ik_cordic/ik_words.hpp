// The words of the block ik_cordic: formats, constants, and arithmetic that notices when a value does not fit.
//
//   format   fraction bits                 holds
//   length   24, of the unit of length     positions, links
//   unit     30                            entries of a rotation; with the gain G, G^2 or G^3 of one to three passes
//   square   32                            squared lengths
//   angle    a turn is 2^32                signed, wraps
#pragma once

#include <array>
#include <cstdint>

namespace armature::cosim::model::ik {

inline constexpr int kWordBits = 48;  // of the scratch memory
inline constexpr int kLaneBits = 40;  // of a lane of the CORDIC
inline constexpr int kRootBits = 43;  // of an area, the root of a product of two squares
inline constexpr int kGuardBits = 4;  // of a slave lane below its word
inline constexpr int kMainBits = 45;  // magnitude of the vector of the main lane, which has the bits of a word
inline constexpr int kUnitBits = 30;
inline constexpr int kSquareShift = 16;  // from the product of two lengths to a square

inline constexpr std::int64_t kHalfTurn = std::int64_t{1} << 31;
inline constexpr std::int64_t kGain = 1'768'195'363;  // G = 1.6467602581 in format unit
inline constexpr std::int64_t kUngain = 652'032'874;  // 1 / G
inline constexpr std::int64_t kTolerance = 1 << 18;   // 2^-14 in format square: what rounding adds to a reach

// A vector is zero if both components are below 2 to the power of this, in the format that they have.
inline constexpr int kZeroExact = 0;
inline constexpr int kZeroLength = 6;  // 4e-6 of the unit of length
inline constexpr int kZeroWrist = 11;  // |sin theta_5| < 7.0e-7, with the gain G^2
inline constexpr int kNearAxis = 20;   // kFiveR: a tool point within 1/16 of axis 1, an approach 2^-10 from vertical

// atan(2^-i) for the passes of 26 iterations.
inline constexpr std::array<std::int64_t, 26> kArctangents{
    536'870'912, 316'933'406, 167'458'907, 85'004'756, 42'667'331, 21'354'465, 10'679'838, 5'340'245, 2'670'163,
    1'335'087,   667'544,     333'772,     166'886,    83'443,     41'722,     20'861,     10'430,    5'215,
    2'608,       1'304,       652,         326,        163,        81,         41,         20};

// The low `bits` of a value, signed, as a register of the logic keeps them.
[[nodiscard]] constexpr std::int64_t low_bits(std::int64_t value, int bits) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << (64 - bits)) >> (64 - bits);
}
[[nodiscard]] constexpr std::int64_t angle(std::int64_t value) {
  return low_bits(value, 32);
}

// The larger magnitude of two words, in one's complement: what leading bits are counted in.
[[nodiscard]] constexpr std::int64_t magnitude(std::int64_t x, std::int64_t y) {
  return (x < 0 ? ~x : x) | (y < 0 ? ~y : y);
}

// Keeps the low bits of every value, and remembers whether one of them did not fit.
class Widths {
 public:
  [[nodiscard]] std::int64_t keep(std::int64_t value, int bits) {
    const std::int64_t kept = low_bits(value, bits);
    exceeded_ = exceeded_ || kept != value;
    return kept;
  }
  [[nodiscard]] std::int64_t word(std::int64_t value) { return keep(value, kWordBits); }
  // The product of two words without its low `shift` bits, rounded to nearest, halves upwards.
  [[nodiscard]] std::int64_t product(std::int64_t a, std::int64_t b, int shift) {
    __extension__ using Wide = __int128;
    const Wide rounded = (static_cast<Wide>(a) * b + (Wide{1} << (shift - 1))) >> shift;
    exceeded_ = exceeded_ || rounded != static_cast<std::int64_t>(rounded);
    return word(static_cast<std::int64_t>(rounded));
  }
  // The integer part of the square root of a product of two words that are not negative.
  [[nodiscard]] std::int64_t root_of_product(std::int64_t a, std::int64_t b);

  [[nodiscard]] bool exceeded() const { return exceeded_; }

 private:
  bool exceeded_ = false;
};

}  // namespace armature::cosim::model::ik
