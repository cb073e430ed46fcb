// A chip whose ticks do not run as a whole, or do not at random. Its accesses that run ahead are recorded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cosim/soc/soc.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim::test {

// When an access of a core that runs ahead begins and ends.
struct AccessTimes {
  Cycles begins{}, ends{};
};

// A chip that gives no whole ticks, or one that is disturbed at random.
class OtherSoc final : public Soc, private MotionPort {
 public:
  // `rarity`: one access of so many disturbs, and one tick of so many does not begin as a whole; 0: no tick does.
  // Accesses that run ahead are added to `accesses`.
  OtherSoc(std::unique_ptr<Soc> soc, std::uint32_t rarity, std::uint64_t seed, std::vector<AccessTimes>& accesses)
      : soc_{std::move(soc)}, port_{soc_->motion_port()}, rarity_{rarity}, random_{seed}, accesses_{&accesses} {}

  Cycles now() const override { return soc_->now(); }
  bool advance(Cycles limit, StopOn stop_on) override { return soc_->advance(limit, stop_on); }
  Cycles quiet_until() const override { return soc_->quiet_until(); }
  Progress access(const BusRequest& request, Cycles at, Cycles limit) override {
    return soc_->access(request, at, limit);
  }
  std::optional<std::uint32_t> access_unnoticed(const BusRequest& request, TimeAhead& time) override {
    if (rarity_ != 0 && now_and_then()) return std::nullopt;
    const Cycles begins = time.now;
    const std::optional<std::uint32_t> data = soc_->access_unnoticed(request, time);
    if (data) accesses_->push_back({begins, time.now});
    return data;
  }
  void set_clock_running(bool running) override { soc_->set_clock_running(running); }
  void stop_clock_of(ClockGroup group) override { soc_->stop_clock_of(group); }
  bool idle() const override { return soc_->idle(); }
  std::optional<Cycles> start(const BusRequest& request) override { return soc_->start(request); }
  bool has_response() const override { return soc_->has_response(); }
  std::optional<BusResponse> pop_response() override { return soc_->pop_response(); }
  Cycles access_timeout() const override { return soc_->access_timeout(); }
  void set_inputs(const SocInputs& inputs) override { soc_->set_inputs(inputs); }
  const SocOutputs& outputs() const override { return soc_->outputs(); }
  std::uint8_t interrupts() const override { return soc_->interrupts(); }
  void open_wave(const std::filesystem::path& file, WaveFormat format) override { soc_->open_wave(file, format); }
  void close_wave() override { soc_->close_wave(); }
  MotionPort* motion_port() override { return rarity_ != 0 && soc_->motion_port() != nullptr ? this : nullptr; }

 private:
  DecoderTimes decoder_times() const override { return port_->decoder_times(); }
  std::optional<TickPulses> begin() const override { return now_and_then() ? std::nullopt : port_->begin(); }
  bool leave_out(const LineHistory& history) override { return port_->leave_out(history); }
  bool expect(const PerAxis<Counts>& counts, const PerAxis<std::optional<Counts>>& index) override {
    return !now_and_then() && port_->expect(counts, index);
  }
  void finish(const TickPulses& pulses) override { port_->finish(pulses); }
  bool disturbs(const BusRequest& request) const override { return now_and_then() || port_->disturbs(request); }
  void continue_after(Cycles at, const LineHistory& history, bool begun) override {
    port_->continue_after(at, history, begun);
  }
  StepPins step_pins() const override { return port_->step_pins(); }
  Cycles catch_up(Cycles from, Cycles until, const EncoderLines& lines) override {
    return port_->catch_up(from, until, lines);
  }
  bool now_and_then() const { return random_.below(rarity_) == 0; }

  std::unique_ptr<Soc> soc_;
  MotionPort* port_;
  std::uint32_t rarity_;
  mutable armature::test::SplitMix random_;
  std::vector<AccessTimes>* accesses_;
};

}  // namespace armature::cosim::test
