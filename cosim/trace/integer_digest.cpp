#include "cosim/trace/integer_digest.hpp"

#include <bit>

#include "cosim/time/mixed.hpp"

namespace armature::cosim {
namespace {

// Ticks are hashed in blocks, because the set-up of a call costs more than hashing one of them.
constexpr std::size_t kTicksInBuffer = 1024;

static_assert(std::endian::native == std::endian::little);

constexpr std::uint64_t kBegin = 1;

constexpr std::uint64_t mixed(std::uint64_t hash, std::int64_t value) {
  return cosim::mixed(hash, static_cast<std::uint64_t>(value));
}

}  // namespace

std::uint64_t tick_hash(const TraceRow& row) {
  const Telemetry& seen = row.telemetry;
  // Axis by axis a product would wait for the product before it. Those of six axes overlap.
  PerAxis<std::uint64_t> axes;
  axes.fill(kBegin);
  const auto mix = [&axes](auto value_of) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) axes[axis] = mixed(axes[axis], std::int64_t{value_of(axis)});
  };
  mix([&](std::size_t axis) { return seen.commanded[axis].value(); });
  mix([&](std::size_t axis) { return row.pin_pulses[axis]; });
  mix([&](std::size_t axis) { return seen.encoder[axis].value(); });
  mix([&](std::size_t axis) { return seen.correction[axis].value(); });
  mix([&](std::size_t axis) { return row.first_rise[axis]; });
  mix([&](std::size_t axis) { return row.turned[axis]; });
  mix([&](std::size_t axis) { return row.motor_from[axis]; });
  mix([&](std::size_t axis) { return row.motor_to[axis]; });

  std::uint64_t hash = mixed(kBegin, row.tick);
  hash = mixed(hash, std::uint64_t{static_cast<std::uint8_t>(seen.state)});
  hash = mixed(hash, row.cycle);
  for (const std::uint64_t axis : axes) hash = mixed(hash, axis);
  return hash;
}

IntegerDigest::IntegerDigest() : bytes_(kTicksInBuffer * sizeof(std::uint64_t)) {}

std::string IntegerDigest::hex() const {
  flush();
  return sha256_.hex();
}

// Finishing a copy of the hash takes a microsecond, so this is called only for rows that are written.
std::string_view IntegerDigest::prefix() const {
  if (prefix_.empty()) prefix_ = hex().substr(0, kPrefixDigits);
  return prefix_;
}

void IntegerDigest::flush() const {
  sha256_.add({bytes_.data(), used_});
  used_ = 0;
}

}  // namespace armature::cosim
