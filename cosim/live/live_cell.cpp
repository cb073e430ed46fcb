#include "cosim/live/live_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <variant>

#include "cosim/logic/axis_bits.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/scenario/keys/toml_text.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::uint8_t levels_of(AxisSwitch which, const SocInputs& pins) {
  if (which == AxisSwitch::kHome) return pins.home;
  return which == AxisSwitch::kLimitPos ? pins.limit_pos : pins.limit_neg;
}

// Whether two faults hold the same line.
bool is_same_line(const FaultKind& a, const FaultKind& b) {
  const auto* one = std::get_if<SwitchStuck>(&a);
  const auto* other = std::get_if<SwitchStuck>(&b);
  if (one == nullptr || other == nullptr) return a.index() == b.index();
  return one->axis == other->axis && one->which == other->which;
}

void set_duration(FaultKind& kind, double duration_s) {
  std::visit(
      [duration_s]<class Kind>(Kind& fault) {
        if constexpr (FaultWithDuration<Kind>) fault.duration_s = duration_s;
      },
      kind);
}

std::string toml_of(const FaultSpec& fault) {
  std::string text = fmt::format("{{at_s={},kind=\"{}\"", toml_text(fault.at_s), fault_kind_name(fault.kind));
  for (const NamedValue& parameter : fault_parameters(fault.kind)) {
    const auto write = [&]<class Value>(const Value& value) {
      if constexpr (!std::is_same_v<Value, std::monostate>) {
        text += fmt::format(",{}={}", parameter.key, toml_text(value));
      }
    };
    std::visit(write, parameter.value);
  }
  return text + "}";
}

std::string toml_of(const InputSpec& input) {
  return fmt::format("{{at_s={},pin={},level={}}}", toml_text(input.at_s), input.pin, input.level ? 1 : 0);
}

template <class Spec>
std::string toml_of(std::string_view key, const std::vector<Spec>& specs) {
  std::string text;
  for (const Spec& spec : specs) text += (text.empty() ? "" : ",") + toml_of(spec);
  return fmt::format("{}=[{}]", key, text);
}

}  // namespace

void LiveCell::click_input(std::int64_t pin) {
  const bool level = (run_.look().inputs.gpio >> (pin - 1) & 1) != 0;
  run_.add_action(InputSpec{.at_s = to_seconds(run_.now()), .pin = pin, .level = !level});
}

void LiveCell::click_switch(int axis, AxisSwitch which) {
  const bool level = has_bit(levels_of(which, run_.look().inputs), static_cast<std::size_t>(axis - 1));
  click(SwitchStuck{.axis = axis, .which = which, .level = level ? 0 : 1, .duration_s = kMaxDurationS});
}

void LiveCell::click_estop() {
  click(Estop{.duration_s = kMaxDurationS});
}

void LiveCell::click(const FaultKind& held_now) {
  const auto found =
      std::ranges::find_if(held_, [&](const FaultSpec& held) { return is_same_line(held.kind, held_now); });
  if (found == held_.end()) {
    held_.push_back({.at_s = to_seconds(run_.now()), .kind = held_now});
    run_.add_action(held_.back());
  } else {
    run_.end_fault(*found);
    held_.erase(found);
  }
}

Json LiveCell::held() const {
  Json json;
  for (const AxisSwitch which : {AxisSwitch::kHome, AxisSwitch::kLimitPos, AxisSwitch::kLimitNeg}) {
    int bits = 0;
    for (const FaultSpec& held : held_) {
      const auto* stuck = std::get_if<SwitchStuck>(&held.kind);
      if (stuck != nullptr && stuck->which == which) bits |= 1 << (stuck->axis - 1);
    }
    json[std::string{word_of(which)}] = bits;
  }
  json["estop"] =
      std::ranges::any_of(held_, [](const FaultSpec& held) { return std::holds_alternative<Estop>(held.kind); });
  return json;
}

std::vector<std::string> LiveCell::overrides() const {
  return {toml_of("fault", faults_), toml_of("input", inputs_)};
}

void LiveCell::on_action(const ScriptAction& action, const RunPlace& place) {
  if (const auto* fault = std::get_if<FaultSpec>(&action)) faults_.push_back(*fault);
  if (const auto* end = std::get_if<FaultEnd>(&action)) end_held(end->fault, place.at);
  if (const auto* input = std::get_if<InputSpec>(&action)) on_input(*input);
}

// A fault that was held gets the duration that it had.
void LiveCell::end_held(const FaultSpec& fault, Cycles at) {
  if (fault_duration_s(fault.kind) != kMaxDurationS) return;
  const auto found = std::ranges::find(faults_, fault);
  if (found != faults_.end()) set_duration(found->kind, to_seconds(at) - fault.at_s);
}

// A scenario must not set a level that a pin has already, nor twice at a time.
void LiveCell::on_input(const InputSpec& input) {
  const auto is_of_pin = [&input](const InputSpec& other) { return other.pin == input.pin; };
  const auto before = std::find_if(inputs_.rbegin(), inputs_.rend(), is_of_pin);
  const bool level_before = before != inputs_.rend() && before->level;
  if (input.level == level_before) return;
  if (before != inputs_.rend() && before->at_s == input.at_s) {
    inputs_.erase(std::next(before).base());
  } else {
    inputs_.push_back(input);
  }
}

}  // namespace armature::cosim
