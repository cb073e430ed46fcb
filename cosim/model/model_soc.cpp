#include "cosim/model/model_soc.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "cosim/bus/axi_lite_master.hpp"
#include "cosim/fabric/pin_trace.hpp"
#include "cosim/model/bus.hpp"
#include "cosim/model/logic.hpp"
#include "cosim/model/logic_motion.hpp"
#include "cosim/model/quick_access.hpp"

namespace armature::cosim::model {
namespace {

template <class Variant>
class ModelSoc final : public Soc {
 public:
  ModelSoc(const BusSpec& bus, std::uint64_t seed)
      : spec_{bus}, times_{bus}, master_{bus, seed}, quick_{is_quick(bus)} {}

  // ---- time
  [[nodiscard]] Cycles now() const override { return logic_.now() + stood_; }

  bool advance(Cycles limit, StopOn stop_on) override {
    if (!clock_running_) {
      stood_ = std::max(stood_, limit - logic_.now());
      return false;
    }
    if (!access_ && is_silent() && limit - stood_ < logic_.wakes_at()) {
      if (logic_.now() < limit - stood_) logic_.pass(limit - stood_);
      return false;
    }
    const std::uint8_t irq = interrupts();
    while (now() < limit) {
      const bool changed = run_to(limit - stood_);
      const bool finished = response_.has_value();
      const bool stopped = stop_on == StopOn::kPinChange   ? changed
                           : stop_on == StopOn::kInterrupt ? changed && interrupts() != irq
                                                           : false;
      if (stopped || finished) return stopped;
    }
    return false;
  }

  [[nodiscard]] Cycles quiet_until() const override {
    if (!clock_running_ || !is_silent()) return now();
    return logic_.wakes_at() + stood_;
  }

  void set_clock_running(bool running) override {
    if (!running && access_) show_handshakes();
    if (running && !clock_running_) master_.stood_still(stood_ - stood_before_);
    if (!running) stood_before_ = stood_;
    clock_running_ = running;
  }

  void stop_clock_of(ClockGroup group) override {
    if (access_) show_handshakes();
    quick_ = false;
    logic_.stop_clock_of(group);
    bus_.stop(Logic<Variant>::ports_of(group));
  }

  // ---- registers
  [[nodiscard]] bool idle() const override { return !access_ && master_.idle() && !response_; }

  std::optional<Cycles> start(const BusRequest& request) override {
    if (!quick_ || !clock_running_ || handshakes_) {
      master_.start(request, now());
      handshakes_ = true;
      return std::nullopt;
    }
    access_ = quick_access(request, logic_.now(), times_, Variant::kBases);
    return access_->ends + stood_;
  }

  Progress access(const BusRequest& request, Cycles at, Cycles limit) override {
    const std::optional<std::size_t> port = port_of(request.addr, Variant::kBases);
    const Cycles start = at - stood_, executed = start + times_.executed, ends = start + times_.ends(request.write);
    const bool alone =
        quick_ && clock_running_ && is_silent() && port && ends + stood_ <= limit && logic_.wakes_at() > executed;
    if (!alone) [[unlikely]]
      return Soc::access(request, at, limit);
    Answer answer;
    bool changed = logic_.access(*port, executed, strobes_of(request), answer), fell = false;
    while (!changed && logic_.wakes_at() <= ends) {
      const SocOutputs before = logic_.outputs();
      if (!compute_next_edge()) continue;
      changed = !only_interrupts_fell(before, logic_.outputs());
      fell = true;
    }
    if (changed) [[unlikely]]
      return shown(request, start, answer);
    logic_.pass(ends);
    return {response_of(request, answer), false, fell, ends + stood_, logic_.wakes_at() + stood_};
  }

  std::optional<std::uint32_t> access_unnoticed(const BusRequest& request, TimeAhead& time) override {
    const Cycles ends = time.now + times_.ends(request.write);
    if (!quick_ || ends >= time.horizon) return std::nullopt;
    const std::optional<std::uint32_t> data = logic_.access_unnoticed(request, time.now - stood_ + times_.executed);
    if (!data) return std::nullopt;
    logic_.pass(ends - stood_);
    time.now = ends;
    return data;
  }

  [[nodiscard]] bool has_response() const override { return response_.has_value(); }
  std::optional<BusResponse> pop_response() override { return std::exchange(response_, std::nullopt); }
  [[nodiscard]] Cycles access_timeout() const override { return Cycles{spec_.timeout_cycles}; }

  // ---- pins
  void set_inputs(const SocInputs& inputs) override { logic_.set_inputs(inputs); }
  [[nodiscard]] const SocOutputs& outputs() const override { return logic_.outputs(); }
  [[nodiscard]] std::uint8_t interrupts() const override { return logic_.outputs().irq; }

  // ---- whole ticks
  [[nodiscard]] MotionPort* motion_port() override {
    if constexpr (std::is_same_v<Variant, CountsVariant>) {
      return clock_running_ && stood_ == Cycles{} ? &motion_ : nullptr;
    }
    return nullptr;
  }

  // ---- waveforms
  void add_to_waves(const SoftwareSignals& signals) override { wave_.add(signals); }
  void open_wave(const std::filesystem::path& file, WaveFormat format) override { wave_.open(file, format); }
  void close_wave() override { wave_.close(); }

 private:
  using Answers = typename Logic<Variant>::Answers;

  // The edge of wakes_at().
  bool compute_next_edge() {
    logic_.pass(logic_.wakes_at() - Cycles{1});
    return logic_.edge();
  }

  // An access that was executed, during which an output has changed at this edge.
  Progress shown(const BusRequest& request, Cycles start, const Answer& answer) {
    access_ = quick_access(request, start, times_, Variant::kBases);
    access_->answer = answer;
    if (access_->ends == logic_.now()) end_access();
    return {.response = pop_response(),
            .pins_changed = true,
            .interrupts_fell = false,
            .ends = now(),
            .quiet_until = quiet_until()};
  }

  // Whether neither handshakes nor a waveform need every edge.
  [[nodiscard]] bool is_silent() const { return !handshakes_ && !wave_.is_open(); }

  // Runs to the next edge that must be computed, or to `end`. Returns whether an output has changed.
  bool run_to(Cycles end) {
    Cycles next = is_silent() ? logic_.wakes_at() : logic_.now() + Cycles{1};
    if (access_) next = std::min(next, access_->next_edge(logic_.now()));
    if (next > end) {
      logic_.pass(end);
      return false;
    }
    if (access_ && access_->ends == next && next < logic_.wakes_at() && !wave_.is_open()) {
      logic_.pass(next);
      end_access();
      return false;
    }
    logic_.pass(next - Cycles{1});
    const bool changed = handshakes_ ? edge_with_handshakes() : edge();
    if (wave_.is_open()) wave_.dump(now(), logic_.inputs(), logic_.outputs());
    return changed;
  }

  bool edge() {
    const bool executes = access_ && access_->port && access_->executed == logic_.now() + Cycles{1};
    if (executes) return logic_.edge(*access_->port, access_->strobes(), access_->answer);
    const bool changed = logic_.edge();
    if (access_ && access_->ends == logic_.now()) end_access();
    return changed;
  }

  void end_access() {
    response_ = access_->response();
    access_.reset();
  }

  bool edge_with_handshakes() {
    Answers answers;
    const bool changed = logic_.edge(bus_.accesses(), answers);
    bus_.edge(logic_.now(), master_.pins(), answers);
    step_master(now());
    return changed;
  }

  // Brings master and crossbar to where they are in the middle of the access under way.
  void show_handshakes() {
    const QuickAccess access = *std::exchange(access_, std::nullopt);
    master_.start(access.request, access.started + stood_);
    handshakes_ = true;
    for (Cycles at = access.started + Cycles{1}; at <= logic_.now(); at += Cycles{1}) {
      Answers answers;
      if (access.port && at == access.executed) answers[*access.port] = access.answer;
      bus_.edge(at, master_.pins(), answers);
      step_master(at + stood_);
    }
  }

  void step_master(Cycles at) {
    if (!master_.idle() && at >= master_.next_event()) response_ = master_.step(at, bus_.pins());
    handshakes_ = !master_.idle() || bus_.is_active(master_.pins());
  }

  static auto motion_of(Logic<Variant>& logic) {
    if constexpr (std::is_same_v<Variant, CountsVariant>) {
      return LogicMotion{logic};
    } else {
      return std::monostate{};
    }
  }

  BusSpec spec_;
  QuickTimes times_;
  Logic<Variant> logic_;
  Bus<Logic<Variant>::kBlocks> bus_{Variant::kBases};
  AxiLiteMaster master_;
  bool handshakes_ = false;            // the master is busy, or the coming edge changes the bus
  std::optional<QuickAccess> access_;  // under way, in times of logic_
  std::optional<BusResponse> response_;
  bool quick_;
  bool clock_running_ = true;
  Cycles stood_{};         // cycles without an edge
  Cycles stood_before_{};  // at the begin of the stop under way
  PinTrace wave_;
  std::conditional_t<std::is_same_v<Variant, CountsVariant>, LogicMotion, std::monostate> motion_{motion_of(logic_)};
};

}  // namespace

std::unique_ptr<Soc> make_model_soc(Variant variant, const BusSpec& bus, std::uint64_t seed) {
  if (variant == Variant::kPaper) return std::make_unique<ModelSoc<PaperVariant>>(bus, seed);
  return std::make_unique<ModelSoc<CountsVariant>>(bus, seed);
}

}  // namespace armature::cosim::model
