// The two counters of axi_timer, alone or as one of 64 bits (rtl/axi_timer/README.md: period, cascade, freeze).
//
// A period ends at the edge at which the counter wraps. The wrapped value shows for one clock, in a cascade for three.
// The edge after that reloads, or the counter holds. Between such edges a counter stands or moves by one per clock, so
// only its count at the latest computed edge is stored.
#pragma once

#include <array>
#include <cstdint>

#include "cosim/model/block.hpp"
#include "cosim/model/timer/timer_registers.hpp"

namespace armature::cosim::model {

class TimerCounters {
 public:
  struct Mode {
    bool cascade = false;
    bool pwm = false;     // timer 1 reloads together with timer 0
    bool frozen = false;  // no counter moves; LOAD works
  };

  // TCR after the edge `at`: the latest computed one, or a later one before the edge that plan() returned.
  [[nodiscard]] std::uint32_t count(unsigned timer, Cycles at) const;

  // One edge, with the registers and the mode before it. Bit i of the result: a period of timer i ends. The periods of
  // a cascade are those of timer 0.
  unsigned edge(Cycles at, const TimerRegisterPair& registers, Mode mode);

  // After an edge: the registers and the mode of the edges to come. Returns the first of them that edge() must compute.
  Cycles plan(const TimerRegisterPair& registers, Mode mode);

 private:
  // What an edge does to a counter.
  enum class Motion : std::uint8_t { kStands, kLoads, kShowsEnd, kReloads, kCounts };

  struct Counter {
    std::uint32_t count = 0;
    std::uint32_t step = 0;  // per edge that is left out, modulo 2^32
    std::uint8_t shows = 0;  // edges at which the wrapped value still stays
    bool wrapped = false;    // the period has ended: count is the wrapped value
  };

  [[nodiscard]] Motion motion(unsigned timer, const TimerRegisters& registers, Mode mode, bool reloads_itself) const;
  [[nodiscard]] std::uint64_t wide() const;
  void set_wide(std::uint64_t count);
  void catch_up(Cycles at);
  void load(unsigned timer, std::uint32_t start);
  bool move_alone(unsigned timer, Motion motion, const TimerRegisters& registers);
  bool move_wide(Motion motion, const TimerRegisterPair& registers);
  Cycles plan_alone(unsigned timer, Motion motion, const TimerRegisters& registers);
  Cycles plan_wide(Motion motion, const TimerRegisterPair& registers);
  Cycles plan_load(unsigned timer, const TimerRegisters& registers) const;
  [[nodiscard]] Motion motion_of_second(Motion first, const TimerRegisterPair& registers, Mode mode) const;

  std::array<Counter, 2> counters_;
  std::uint64_t wide_step_ = 0;  // of both counters as one, per edge that is left out
  Cycles at_{0};                 // the edge after which the counts are those stored
};

}  // namespace armature::cosim::model
