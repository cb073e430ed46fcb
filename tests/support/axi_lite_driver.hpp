// AXI4-Lite master for block tests: five independent channels, every legal way to stall, and a protocol checker.
//
// Requests are posted and answered in order per direction; writes and reads overlap. What is posted at once is offered
// as early as the stall pattern allows, so the next AW, W or AR is already waiting while the last one is in flight.
//
// Checked on every clock (a violation is a GoogleTest failure):
//   - BVALID and RVALID, once high, stay high with the same payload until READY;
//   - one B per accepted AW and W pair, one R per accepted AR, never earlier, never EXOKAY;
//   - no output changes between clock edges, whatever the inputs do: there is no combinational path;
//   - no response during reset.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <ostream>
#include <string>
#include <utility>

#include "tests/support/split_mix.hpp"

namespace armature::test {

enum class AxiStall {
  kNone,          // requests back to back, READY always high
  kIdle,          // random gaps before every VALID
  kBackPressure,  // BREADY and RREADY mostly low, also for long
  kAwBeforeW,     // data is offered later than its address
  kWBeforeAw,     // address is offered later than its data
};

inline constexpr AxiStall kAllAxiStalls[] = {AxiStall::kNone, AxiStall::kIdle, AxiStall::kBackPressure,
                                             AxiStall::kAwBeforeW, AxiStall::kWBeforeAw};

inline std::string name_of(AxiStall stall) {
  switch (stall) {
    case AxiStall::kNone:
      return "NoStall";
    case AxiStall::kIdle:
      return "IdleInserted";
    case AxiStall::kBackPressure:
      return "BackPressure";
    case AxiStall::kAwBeforeW:
      return "AwBeforeW";
    case AxiStall::kWBeforeAw:
      return "WBeforeAw";
  }
  return "unknown";
}

enum class AxiResp : std::uint8_t { kOkay = 0, kExOkay = 1, kSlvErr = 2, kDecErr = 3, kNone = 0xFF };

struct AxiReadResult {
  AxiResp resp = AxiResp::kNone;
  std::uint32_t data = 0;
  friend bool operator==(const AxiReadResult&, const AxiReadResult&) = default;
};

inline std::ostream& operator<<(std::ostream& out, const AxiReadResult& r) {
  return out << "{resp " << static_cast<int>(r.resp) << ", data 0x" << std::hex << r.data << std::dec << "}";
}

// `Dut` is a verilated model with the ports rst_ni and s_axi_*.
template <class Dut>
class AxiLiteDriver {
 public:
  // Longest wait for an answer, in clocks; far beyond what any stall pattern adds.
  static constexpr int kTimeoutClocks = 1000;

  static constexpr int kReportedViolations = 5;

  // `tick` runs one clock of the model and of everything the test connects to it.
  AxiLiteDriver(Dut& dut, std::function<void()> tick, AxiStall stall, std::uint64_t seed)
      : dut_(dut), tick_(std::move(tick)), stall_(stall), random_(seed) {
    drive();
    dut_.eval();
    last_ = sample();
  }

  void post_write(std::uint32_t addr, std::uint32_t data, unsigned strobe = 0xF) {
    aw_.queue.push_back({addr, 0, gap(AxiStall::kWBeforeAw)});
    w_.queue.push_back({data, strobe, gap(AxiStall::kAwBeforeW)});
  }
  void post_read(std::uint32_t addr) { ar_.queue.push_back({addr, 0, gap(AxiStall::kIdle)}); }

  // Answers that have arrived and have not been taken by the caller, oldest first.
  std::deque<AxiResp> write_answers;
  std::deque<AxiReadResult> read_answers;

  // One clock.
  void step() {
    offer();
    drive();
    dut_.eval();
    const Outputs before = sample();
    require(before == last_, "an AXI output follows an input without a clock edge");
    const bool resetting = dut_.rst_ni == 0;
    const bool aw = aw_.valid && before.awready, w = w_.valid && before.wready, ar = ar_.valid && before.arready;
    const bool b = before.bvalid && bready_, r = before.rvalid && rready_;
    tick_();
    ++clock_;
    last_ = sample();
    if (resetting) {
      forget();
      require(!last_.bvalid && !last_.rvalid, "response in reset");
      return;
    }
    // A response that nobody asked for has been reported when it appeared; it answers nothing.
    if (b && answered_writes_ < std::min(aw_.accepted, w_.accepted)) {
      write_answers.push_back(static_cast<AxiResp>(before.bresp));
      ++answered_writes_;
    }
    if (r && answered_reads_ < ar_.accepted) {
      read_answers.push_back({static_cast<AxiResp>(before.rresp), before.rdata});
      ++answered_reads_;
    }
    if (aw) aw_.accept();
    if (w) w_.accept();
    if (ar) ar_.accept();
    check(before, b, r);
  }

  void step(int clocks) {
    for (int i = 0; i < clocks; ++i) step();
  }

  // Runs until everything posted has been answered.
  void drain() {
    for (int waited = 0; outstanding(); ++waited) {
      if (waited == kTimeoutClocks) {
        ADD_FAILURE() << "no answer within " << kTimeoutClocks << " clocks" << where();
        forget();
        return;
      }
      const auto answers = answered_writes_ + answered_reads_;
      step();
      if (answered_writes_ + answered_reads_ != answers) waited = 0;
    }
  }

  // One access, waiting for its answer; nothing may be outstanding.
  AxiResp write(std::uint32_t addr, std::uint32_t data, unsigned strobe = 0xF) {
    post_write(addr, data, strobe);
    drain();
    return take(write_answers, AxiResp::kNone);
  }
  AxiReadResult read(std::uint32_t addr) {
    post_read(addr);
    drain();
    return take(read_answers, AxiReadResult{});
  }

  // Drops every request, as a master in reset does.
  void forget() {
    aw_ = w_ = ar_ = Channel{};
    write_answers.clear();
    read_answers.clear();
    answered_writes_ = answered_reads_ = 0;
    bready_ = rready_ = false;
    b_stall_ = r_stall_ = 0;
    drive();
  }

  [[nodiscard]] bool outstanding() const {
    return answered_writes_ != aw_.accepted + static_cast<std::int64_t>(aw_.queue.size()) ||
           answered_reads_ != ar_.accepted + static_cast<std::int64_t>(ar_.queue.size());
  }
  [[nodiscard]] std::int64_t clock() const { return clock_; }  // steps so far
  [[nodiscard]] SplitMix& random() { return random_; }

 private:
  struct Beat {
    std::uint32_t payload;
    unsigned strobe;
    int gap;  // clocks still to wait before VALID
  };

  struct Channel {
    std::deque<Beat> queue;  // front: on offer or next
    bool valid = false;
    std::int64_t accepted = 0;  // beats
    std::int64_t offered = 0;
    void accept() {
      valid = false;
      queue.pop_front();
      ++accepted;
    }
  };

  struct Outputs {
    bool awready = false, wready = false, bvalid = false, arready = false, rvalid = false;
    unsigned bresp = 0, rresp = 0;
    std::uint32_t rdata = 0;
    friend bool operator==(const Outputs&, const Outputs&) = default;
  };

  template <class T>
  static T take(std::deque<T>& answers, T none) {
    if (answers.empty()) return none;
    T answer = answers.front();
    answers.pop_front();
    return answer;
  }

  // Clocks before VALID for a channel that the pattern `late` delays.
  int gap(AxiStall late) {
    if (stall_ == AxiStall::kIdle) return static_cast<int>(random_.below(6));
    return stall_ == late ? 1 + static_cast<int>(random_.below(7)) : 0;
  }

  // The gap of a beat runs from the first clock in which it may be offered.
  static void offer(Channel& channel, bool may) {
    if (channel.valid || channel.queue.empty() || !may) return;
    if (channel.queue.front().gap-- > 0) return;
    channel.valid = true;
    ++channel.offered;
  }

  // Decides which VALID and READY the coming edge sees.
  void offer() {
    if (dut_.rst_ni == 0) return;
    const bool aw_may = stall_ != AxiStall::kWBeforeAw || w_.offered > aw_.accepted;
    const bool w_may = stall_ != AxiStall::kAwBeforeW || aw_.offered > w_.accepted;
    offer(aw_, aw_may);
    offer(w_, w_may);
    offer(ar_, true);
    bready_ = ready(b_stall_);
    rready_ = ready(r_stall_);
  }

  bool ready(int& stall) {
    if (stall_ != AxiStall::kBackPressure) return true;
    if (stall > 0) return --stall, false;
    stall = static_cast<int>(random_.below(8) == 0 ? 20 + random_.below(20) : random_.below(5));
    return true;
  }

  template <class Port, class Value>
  static void set(Port& port, Value value) {
    port = static_cast<Port>(value);
  }

  // The payload of an idle channel is noise: only VALID gives it a meaning.
  void drive() {
    const auto noise = static_cast<std::uint32_t>(random_.next());
    set(dut_.s_axi_awaddr_i, aw_.valid ? aw_.queue.front().payload : noise);
    set(dut_.s_axi_wdata_i, w_.valid ? w_.queue.front().payload : noise);
    set(dut_.s_axi_wstrb_i, w_.valid ? w_.queue.front().strobe : noise & 0xF);
    set(dut_.s_axi_araddr_i, ar_.valid ? ar_.queue.front().payload : ~noise);
    set(dut_.s_axi_awvalid_i, aw_.valid);
    set(dut_.s_axi_wvalid_i, w_.valid);
    set(dut_.s_axi_arvalid_i, ar_.valid);
    set(dut_.s_axi_bready_i, bready_);
    set(dut_.s_axi_rready_i, rready_);
  }

  [[nodiscard]] Outputs sample() const {
    return {dut_.s_axi_awready_o != 0, dut_.s_axi_wready_o != 0, dut_.s_axi_bvalid_o != 0, dut_.s_axi_arready_o != 0,
            dut_.s_axi_rvalid_o != 0,  dut_.s_axi_bresp_o,       dut_.s_axi_rresp_o,       dut_.s_axi_rdata_o};
  }

  void check(const Outputs& before, bool b_taken, bool r_taken) {
    if (before.bvalid && !b_taken) {
      require(last_.bvalid, "BVALID dropped before BREADY");
      require(last_.bresp == before.bresp, "BRESP changed while it waited");
    }
    if (before.rvalid && !r_taken) {
      require(last_.rvalid, "RVALID dropped before RREADY");
      require(last_.rresp == before.rresp, "RRESP changed while it waited");
      require(last_.rdata == before.rdata, "RDATA changed while it waited");
    }
    // A response that shows after an edge needs a request accepted at that edge or before.
    if (last_.bvalid) {
      require(std::min(aw_.accepted, w_.accepted) > answered_writes_, "B without a whole request");
      require(last_.bresp != 1, "BRESP is EXOKAY");
    }
    if (last_.rvalid) {
      require(ar_.accepted > answered_reads_, "R without a request");
      require(last_.rresp != 1, "RRESP is EXOKAY");
    }
  }

  // A broken rule fails on every clock; the first few tell everything.
  void require(bool kept, const char* violation) {
    if (!kept && reported_++ < kReportedViolations) ADD_FAILURE() << violation << where();
  }

  [[nodiscard]] std::string where() const { return ", clock " + std::to_string(clock_) + ", " + name_of(stall_); }

  Dut& dut_;
  std::function<void()> tick_;
  AxiStall stall_;
  SplitMix random_;
  Channel aw_, w_, ar_;
  std::int64_t answered_writes_ = 0, answered_reads_ = 0;
  bool bready_ = false, rready_ = false;
  int b_stall_ = 0, r_stall_ = 0;
  Outputs last_;
  std::int64_t clock_ = 0;
  int reported_ = 0;
};

}  // namespace armature::test
