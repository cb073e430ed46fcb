// The only file that includes the verilated models.
#include "cosim/fabric/verilated_fabric.hpp"

#include <Varm_soc.h>
#include <Varm_soc___024root.h>
#include <Varm_soc_paper.h>
#include <Varm_soc_paper___024root.h>
#include <verilated.h>
#include <Varm_soc_direct.hpp>
#include <Varm_soc_flops.hpp>
#include <Varm_soc_paper_direct.hpp>
#include <Varm_soc_paper_flops.hpp>
#if VM_COVERAGE
#include <unistd.h>
#include <verilated_cov.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "cosim/fabric/direct_eval.hpp"
#include "cosim/fabric/flops/flops.hpp"
#include "cosim/fabric/gated_clocks.hpp"
#include "cosim/fabric/model_bus.hpp"
#include "cosim/fabric/model_pins.hpp"
#include "cosim/fabric/software_trace.hpp"
#include "cosim/fabric/wave_file.hpp"

namespace armature::cosim {
namespace {

// The bit of active_o.
constexpr unsigned clock_of(ClockGroup group) {
  return 1u << static_cast<unsigned>(group);
}

constexpr int kTraceAllLevels = 99;

// What changes when an output pin does, as long as no input pin does: some words of the model, in which the pins have
// the places below (Verilator 5.006 keeps the order of the ports).
struct PinWords {
  std::uint32_t arm = 0;
  std::uint64_t serial = 0;
  std::uint32_t timer = 0;
  std::uint64_t others = 0;

  friend bool operator==(const PinWords&, const PinWords&) = default;
};

// Does not compile with another number of output pins: PinWords must have each of them.
static_assert([] {
  [[maybe_unused]] const auto [step, dir, servo_on, heartbeat, uart_txd, uart_rts_n, uart_dtr_n, gpio, pwm, trigger,
                               irq] = SocOutputs{};
  return true;
}());

template <class Root>
[[nodiscard]] [[gnu::always_inline]] inline PinWords pin_words(const Root& root) {
  const std::byte* bytes = std::as_bytes(std::span{&root, 1}).data();
  const auto place_of = [bytes](const auto& pin) { return std::as_bytes(std::span{&pin, 1}).data() - bytes; };
  const auto arm = place_of(root.step_o), serial = place_of(root.uart_txd_o), timer = place_of(root.irq_o) - 3;
  const auto follows = [&](const auto& pin, std::ptrdiff_t first, std::ptrdiff_t size) {
    return place_of(pin) >= first && place_of(pin) < first + size;
  };
  if (!follows(root.dir_o, arm, 4) || !follows(root.servo_on_o, arm, 4) || !follows(root.heartbeat_o, arm, 4) ||
      !follows(root.uart_rts_no, serial, 8) || !follows(root.uart_dtr_no, serial, 8) ||
      !follows(root.pwm_o, timer, 4) || !follows(root.trigger_o, timer, 4)) {
    return {.others = output_word(root)};
  }
  PinWords words{.others = root.gpio_o};
  std::memcpy(&words.arm, bytes + arm, sizeof words.arm);
  std::memcpy(&words.serial, bytes + serial, sizeof words.serial);
  std::memcpy(&words.timer, bytes + timer, sizeof words.timer);
  return words;
}

// Model: Varm_soc or Varm_soc_paper, which have the same pins.
template <class Model>
class VerilatedFabric final : public Fabric {
 public:
  VerilatedFabric() {
    context_.traceEverOn(true);
    context_.fatalOnError(false);
    model_.trace(&vcd_, kTraceAllLevels);
    set_inputs({});
    set_master({});
    reset(model_);
    outputs_ = sample_pins(model_);
  }

  ~VerilatedFabric() override {
    // The destructor of the model removes its scopes from the context of the thread. Without this line that is the
    // context of the fabric that was created last.
    Verilated::threadContextp(&context_);
    if (vcd_.isOpen()) vcd_.close();
    model_.final();
#if VM_COVERAGE
    // For verilator_coverage: one file per process, so that tests can run in parallel.
    context_.coveragep()->write(("rtl_coverage_" + std::to_string(getpid()) + ".dat").c_str());
#endif
  }

  void set_inputs(const SocInputs& in) override {
    drive_pins(model_, in);
  }

  void set_master(const AxiMasterPins& m) override {
    drive_bus(model_, m);
  }

  bool run(std::int64_t limit) override {
    if (just_flipped_) [[unlikely]]
      return run_after_flip();
    const bool changed = run_unflipped(limit);
    if (changed) sample_outputs();
    return changed;
  }

  void stand_still(std::int64_t cycles) override {
    // The software continues.
    if (vcd_.isOpen() && cycles > 0) vcd_.dump(static_cast<std::uint64_t>(cycle_ + 1) * kCycleNs);
    cycle_ += cycles;
  }

  void stop_clock_of(ClockGroup group) override {
    static_assert(clock_of(ClockGroup::kIo) == kIoClock && clock_of(ClockGroup::kMotion) == kMotionClock &&
                  clock_of(ClockGroup::kEncoder) == kEncoderClock);
    stopped_ |= clock_of(group);
  }

  std::vector<Flop> flops() override {
    return known_flops().list();
  }

  bool flip(std::string_view flop, int bit) override {
    if (!known_flops().flip(flop, bit)) return false;
    just_flipped_ = true;
    return true;
  }

  std::uint64_t digest() override {
    return known_flops().digest() ^ pin_changes_;
  }

  const SocOutputs& outputs() const override {
    return outputs_;
  }

  AxiSlavePins slave() const override {
    return sample_bus(model_);
  }

  Cycles cycle() const override {
    return Cycles{cycle_};
  }

  void add_to_waves(const SoftwareSignals& signals) override {
    software_.add_to(vcd_, signals);
  }

  void open_wave(const std::filesystem::path& file, WaveFormat format) override {
    close_wave();
    file_.set_format(format);
    vcd_.open(file.c_str());
    if (!vcd_.isOpen()) throw WaveError(file.string() + ": cannot write the waveform file");
  }

  void close_wave() override {
    if (!vcd_.isOpen()) return;
    vcd_.close();
    if (const auto& error = file_.error(); !error.empty()) throw WaveError(error);
  }

 private:
  bool run_unflipped(std::int64_t limit) {
    const bool changed = vcd_.isOpen()   ? run_with_waves(limit)
                         : stopped_ == 0 ? run_edges(limit, NoneStopped{})
                                         : run_edges(limit, stopped_);
    if (context_.gotError()) [[unlikely]]
      throw LogicCheckFailed{cycle()};
    return changed;
  }

  // One edge. The flip may have changed pins, too.
  bool run_after_flip() {
    just_flipped_ = false;
    run_unflipped(1);
    if (sample_pins(model_) == outputs_) return false;
    sample_outputs();
    return true;
  }

  void sample_outputs() {
    constexpr std::uint64_t kOddFactor = 0x9E37'79B9'7F4A'7C15;
    outputs_ = sample_pins(model_);
    pin_changes_ = (pin_changes_ ^ output_word(model_)) * kOddFactor + static_cast<std::uint64_t>(cycle_);
  }

  Flops& known_flops() {
    if (!flops_) {
      std::vector<FlopPlace> places;
      if constexpr (FlopPlaces<Model>::kKnown) places = FlopPlaces<Model>::of(model_);
      flops_.emplace(places, [this] {
        if constexpr (FlopPlaces<Model>::kKnown) FlopPlaces<Model>::settle(model_);
      });
    }
    return *flops_;
  }

  // `stopped` is stopped_, or the constant 0, which costs no time.
  using NoneStopped = std::integral_constant<unsigned, 0>;
  bool run_edges(std::int64_t limit, auto stopped) {
    const auto& root = *model_.rootp;
    const unsigned requested = requested_clocks(root);  // the master does not change meanwhile
    const PinWords before = pin_words(root);
    std::int64_t edges = 0;
    bool changed = false;
    do {
      evaluate_edge(model_, Clocks{.ungated = true, .gated = (root.active_o | requested) & ~stopped});
      changed = pin_words(root) != before;
    } while (++edges < limit && !changed);
    cycle_ += edges;
    return changed;
  }

  bool run_with_waves(std::int64_t limit) {
    const PinWords before = pin_words(*model_.rootp);
    bool changed = false;
    for (std::int64_t i = 0; i < limit && !changed; ++i) {
      ++cycle_;
      set_clocks(model_, needed_clocks(*model_.rootp, 0, stopped_));
      model_.eval();
      dump(0);
      set_clocks(model_, {});
      model_.eval();
      dump(kCycleNs / 2);
      changed = pin_words(*model_.rootp) != before;
    }
    return changed;
  }

  void dump(std::uint64_t after_the_edge_ns) {
    vcd_.dump(static_cast<std::uint64_t>(cycle_) * kCycleNs + after_the_edge_ns);
  }

  // The model uses one thread. Without this the context starts one for each processor, and the process could not be
  // copied (cosim/snapshot). It must be said before the model exists.
  struct Context : VerilatedContext {
    Context() { threads(1); }
  };

  Context context_;
  Model model_{&context_, ""};
  WaveFile file_;
  SoftwareTrace software_{"software"};  // below the scope of the model, `top`
  VerilatedVcdC vcd_{&file_};
  std::int64_t cycle_ = 0;
  unsigned stopped_ = 0;  // gated clocks without edges, bits as in active_o
  bool just_flipped_ = false;
  std::optional<Flops> flops_;  // as soon as somebody asks
  SocOutputs outputs_;
  std::uint64_t pin_changes_ = 0;  // digest of all of them
};

}  // namespace

std::unique_ptr<Fabric> make_verilated_fabric(Variant variant) {
  if (variant == Variant::kPaper) return std::make_unique<VerilatedFabric<Varm_soc_paper>>();
  return std::make_unique<VerilatedFabric<Varm_soc>>();
}

}  // namespace armature::cosim
