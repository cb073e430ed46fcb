#include "cosim/flips/drawn_flips.hpp"

#include <cstddef>

#include "controller/base/timebase.hpp"
#include "cosim/campaign/draw.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

// Random sequences of a seed.
constexpr std::uint64_t kInstants = 0, kMemoryBits = 1;

}  // namespace

std::vector<Flip> flips_of(const std::vector<Flop>& flops, const std::string& block, std::int64_t every) {
  std::vector<Flip> chosen;
  std::int64_t bits = 0;
  for (const Flop& flop : flops) {
    const std::string part = block_of(flop.name);
    if (!block.empty() && part != block) continue;
    for (int bit = 0; bit < flop.bits; ++bit) {
      if (bits++ % every == 0) chosen.push_back({.part = part, .name = flop.name, .bit = bit});
    }
  }
  return chosen;
}

std::vector<Flip> flips_of(const CoreMemory& memory, const std::string& part, std::int64_t bits, std::uint64_t seed) {
  std::vector<Flip> chosen;
  for (std::size_t i = 0; i < memory.parts.size(); ++i) {
    const CoreMemory::Part& from = memory.parts[i];
    if (!part.empty() && from.name != part) continue;
    Draw draw{seed, kMemoryBits, i};
    for (std::int64_t n = 0; n < bits; ++n) {
      const auto word = static_cast<std::uint32_t>(draw.integer(0, from.bytes / 4 - 1));
      const auto [symbol, offset] = memory.place_of(from.begin + 4 * word);
      chosen.push_back(
          {.part = from.name, .name = symbol, .offset = offset, .bit = static_cast<int>(draw.integer(0, 31))});
    }
  }
  return chosen;
}

std::vector<Cycles> instants_of(const UnflippedRun& run, int count, double until_s, std::uint64_t seed) {
  const std::vector<TruePoint>& points = run.path.points;
  const auto moves = [&](std::size_t i) { return points[i].motor_counts != points[i + 1].motor_counts; };
  std::size_t first = 0, last = points.size() - 1;
  while (first + 1 < last && !moves(first)) ++first;
  while (last > first + 1 && (!moves(last - 1) || to_seconds(Cycles{points[last].cycle}) > until_s)) --last;
  Draw draw{seed, kInstants, 0};
  std::vector<Cycles> instants;
  const auto instants_in_all = static_cast<std::size_t>(count);
  for (std::size_t i = 0; i < instants_in_all; ++i) {
    const std::size_t tick = first + (last - first) * (2 * i + 1) / (2 * instants_in_all);
    instants.emplace_back(points[tick].cycle + draw.integer(1, armature::kTickCycles.value()));
  }
  return instants;
}

}  // namespace armature::cosim
