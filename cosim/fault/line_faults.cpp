#include "cosim/fault/line_faults.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/plant/incremental_encoder.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kMiscountGap{100};  // 2 us: the filter of the decoder lets each of the counts pass

template <class Kind>
concept EncoderFault = LineFault<Kind> && requires(const Kind& fault) {
  fault.axis;
} && !requires(const Kind& fault) {
  fault.which;
};

template <class Kind>
std::size_t axis_of(const Kind& fault) {
  return static_cast<std::size_t>(fault.axis - 1);
}

Cycles cycles_of_us(double us) {
  return std::max(Cycles{1}, to_cycles(us * 1e-6));
}

std::uint8_t& pin_of(EncoderLine line, SocInputs& pins) {
  if (line == EncoderLine::kA) return pins.enc_a;
  return line == EncoderLine::kB ? pins.enc_b : pins.enc_z;
}

std::uint8_t& pin_of(AxisSwitch which, SocInputs& pins) {
  if (which == AxisSwitch::kHome) return pins.home;
  return which == AxisSwitch::kLimitPos ? pins.limit_pos : pins.limit_neg;
}

// What the faults do to the pins. `inverted` and `added`: of the fault.
struct Change {
  SocInputs& pins;
  const Plant& plant;
  bool inverted;
  std::int64_t added;

  void invert(std::uint8_t& pin, std::size_t axis) const {
    if (inverted) pin = static_cast<std::uint8_t>(pin ^ bit_of(axis));
  }

  void by(const EncoderStuck& fault) const { set_bit(pin_of(fault.line, pins), axis_of(fault), fault.level != 0); }
  void by(const EncoderCable& fault) const {
    for (const EncoderLine line : {EncoderLine::kA, EncoderLine::kB, EncoderLine::kZ}) {
      set_bit(pin_of(line, pins), axis_of(fault), false);
    }
  }
  void by(const EncoderSwapped& fault) const {
    const bool a = has_bit(pins.enc_a, axis_of(fault)), b = has_bit(pins.enc_b, axis_of(fault));
    set_bit(pins.enc_a, axis_of(fault), b);
    set_bit(pins.enc_b, axis_of(fault), a);
  }
  void by(const EncoderChatter& fault) const { invert(pin_of(fault.line, pins), axis_of(fault)); }
  void by(const EncoderNoise& fault) const { invert(pin_of(fault.line, pins), axis_of(fault)); }
  // The levels of the count that is `added` further. Over the counts they are 00, 10, 11, 01.
  void by(const EncoderMiscount& fault) const {
    const bool a = has_bit(pins.enc_a, axis_of(fault)), b = has_bit(pins.enc_b, axis_of(fault));
    const Counts count{(b ? (a ? 2 : 3) : (a ? 1 : 0)) + added};
    set_bit(pins.enc_a, axis_of(fault), IncrementalEncoder::a(count));
    set_bit(pins.enc_b, axis_of(fault), IncrementalEncoder::b(count));
  }
  void by(const IndexSlip& fault) const {
    set_bit(pins.enc_z, axis_of(fault), plant.shows_index(axis_of(fault), Counts{-fault.counts}));
  }
  void by(const SwitchStuck& fault) const { set_bit(pin_of(fault.which, pins), axis_of(fault), fault.level != 0); }
  void by(const SwitchBounce& fault) const { invert(pin_of(fault.which, pins), axis_of(fault)); }
  void by(const UartBreak&) const { pins.uart_rxd = false; }
  void by(const UartNoise&) const {
    if (inverted) pins.uart_rxd = !pins.uart_rxd;
  }
  void by(const auto&) const {}  // of other parts
};

}  // namespace

void LineFaults::begin(const FaultKind& kind, Cycles now) {
  std::visit(
      [&]<class Kind>(const Kind& fault) {
        if constexpr (EncoderFault<Kind>) false_encoders_ |= bit_of(axis_of(fault));
      },
      kind);
  faults_.push_back({.kind = kind});
  toggle(faults_.back(), now);
}

void LineFaults::end(const FaultKind& kind) {
  const auto found = std::ranges::find(faults_, kind, &Fault::kind);
  if (found != faults_.end()) faults_.erase(found);
}

Cycles LineFaults::next_event() const {
  Cycles next = kNever;
  for (const Fault& fault : faults_) next = std::min(next, fault.next);
  return next;
}

void LineFaults::advance(Cycles now) {
  for (Fault& fault : faults_) {
    if (fault.next <= now) toggle(fault, now);
  }
}

// Of a fault that does not toggle it does nothing.
void LineFaults::toggle(Fault& fault, Cycles now) {
  const auto after_half = [&](double period_us) {
    fault.inverted = !fault.inverted;
    fault.next = now + cycles_of_us(period_us / 2);
  };
  if (const auto* chatter = std::get_if<EncoderChatter>(&fault.kind)) after_half(chatter->period_us);
  if (const auto* bounce = std::get_if<SwitchBounce>(&fault.kind)) after_half(bounce->period_us);
  const auto after_gap = [&](const auto& noise) {
    fault.inverted = !fault.inverted;
    const auto twice = static_cast<std::uint64_t>(2 * cycles_of_us(noise.mean_gap_us).value());
    const Cycles gap{static_cast<std::int64_t>(1 + random_.next() % twice)};
    fault.next = now + (fault.inverted ? cycles_of_us(noise.width_us) : gap);
  };
  if (const auto* noise = std::get_if<EncoderNoise>(&fault.kind)) after_gap(*noise);
  if (const auto* noise = std::get_if<UartNoise>(&fault.kind)) after_gap(*noise);
  if (const auto* miscount = std::get_if<EncoderMiscount>(&fault.kind)) {
    if (fault.added != miscount->counts) fault.added += miscount->counts > 0 ? 1 : -1;
    fault.next = fault.added != miscount->counts ? now + kMiscountGap : kNever;
  }
}

void LineFaults::apply_to(SocInputs& pins) const {
  for (const Fault& fault : faults_) {
    const Change change{.pins = pins, .plant = plant_, .inverted = fault.inverted, .added = fault.added};
    std::visit([&](const auto& kind) { change.by(kind); }, fault.kind);
  }
}

}  // namespace armature::cosim
