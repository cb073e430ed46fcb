#include "cosim/check/conservation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/encoder_switch_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/pulse_width_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/bus/register_address.hpp"
#include "cosim/check/shortage.hpp"
#include "cosim/logic/axis_bits.hpp"

namespace armature::cosim {
namespace {

namespace pt = regs::pulse_train;
namespace pw = regs::pulse_width;
namespace en = regs::encoder;

// EMITTED has the same address in both blocks.
static_assert(regs::soc::kPulseWidthBase == regs::soc::kPulseTrainBase && pw::kEmittedOffset == pt::kEmittedOffset &&
              pw::kEmittedStride == pt::kEmittedStride && pw::kEmittedCount == pt::kEmittedCount);

// COUNT is limited to this at the commit (4 Mpps over a 50 us tick).
constexpr std::int32_t kMaxPulsesPerTick = 200;

// Cycles from the effect of an access in a register block until the master accepts its response: 3 cycles in
// axi_lite_slave, the crossbar and the handshake; rounded up.
constexpr std::int64_t kResponsePath = 10;

constexpr std::uint32_t kStopFlags = pt::kFaultEstopMask | pt::kFaultWatchdogMask | pt::kFaultResidualMask;
constexpr std::uint32_t kStopStates = pt::kStatusEstopMask | pt::kStatusWatchdogMask;

}  // namespace

Conservation::Conservation(const Plant& plant, const BusSpec& bus, CheckedLogic logic)
    : plant_{plant},
      paper_{logic.paper},
      // Stalls may delay a response by any time up to the time-out.
      access_tail_{bus.stall_probability > 0.0 ? bus.timeout_cycles : bus.latency_cycles + kResponsePath},
      positions_{plant, {.switched = logic.paper, .input_jitter = logic.input_jitter}} {}

// ---- clock ----

void Conservation::on_clock(Cycles now, bool runs) {
  if (runs != stopped_at_.has_value()) return;
  if (runs) {
    stood_still_ += now - *stopped_at_;
    stopped_at_.reset();
    positions_.on_clock_started(now);
  } else {
    stopped_at_ = now;
    positions_.on_clock_stopped(now);
  }
}

// ---- triggers ----

void Conservation::on_trigger(Cycles now) {
  if (paper_) {
    check_paper_tick(now);
    widths_.on_trigger();
  } else {
    check_tick(now);
  }
  check_drives(now);
  previous_emitted_ = std::exchange(latest_emitted_, pins_);
  positions_.on_trigger(now, trigger_in_doubt(now));

  std::swap(active_, pending_);
  pending_.assign(1, CountSet{});
  pending_may_be_active_ = false;
  pins_at_trigger_ = pins_;
  edges_of_tick_ = std::exchange(edges_, {});
  servo_was_off_ = static_cast<std::uint8_t>(~servo_on_);
  trigger_ = logic_time(now);
  ++triggers_;
}

void Conservation::check_tick(Cycles now) {
  CountSet emitted;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    emitted[axis] = static_cast<std::int32_t>(pins_[axis] - pins_at_trigger_[axis]);
  }
  const auto match = std::find(active_.begin(), active_.end(), emitted);
  if (match == active_.end()) explain_mismatch(now, emitted);
  if (!pending_may_be_active_) return;

  // The last commit came close to the beginning of this tick. If only its counts match the tick, it was active and is
  // used up. If only other counts match, it is still pending. Otherwise both stay possible.
  const bool unknown = match == active_.end();
  if (!unknown && active_.back() != emitted) return;
  if (!unknown && match == active_.end() - 1) {
    pending_.assign(1, CountSet{});
  } else {
    pending_.push_back(CountSet{});
  }
}

void Conservation::explain_mismatch(Cycles now, const CountSet& emitted) {
  // Either a shortage of the latest possible set, or an excess over the first set.
  for (auto set = active_.rbegin(); set != active_.rend(); ++set) {
    if (!std::equal(emitted.begin(), emitted.end(), set->begin(), is_short_of)) continue;
    const auto axis =
        static_cast<std::size_t>(std::mismatch(set->begin(), set->end(), emitted.begin()).first - set->begin());
    record_shortage(now, axis, (*set)[axis], emitted[axis]);
    return;
  }
  const CountSet& set = active_.front();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (is_short_of(emitted[axis], set[axis])) continue;
    report(triggers_, axis, now, fmt::format("{} pulses committed, {} emitted", set[axis], emitted[axis]));
    return;
  }
}

void Conservation::record_shortage(Cycles now, std::size_t axis, std::int32_t committed, std::int32_t emitted) {
  const bool explained = stop_seen_ && *stop_seen_ >= trigger_;
  if (!explained && !shortage_) shortage_ = Shortage{triggers_, axis, now, logic_time(now), committed, emitted};
}

void Conservation::check_paper_tick(Cycles now) {
  const Cycles tick = logic_time(now) - trigger_;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const auto emitted = static_cast<std::int32_t>(pins_[axis] - pins_at_trigger_[axis]);
    if (widths_.allows(axis, emitted, tick)) continue;
    if (const auto whole = widths_.whole_of(axis, emitted, tick)) {
      record_shortage(now, axis, *whole, emitted);
    } else {
      report(triggers_, axis, now,
             fmt::format("the half period makes {} pulses, {} emitted", widths_.expected(axis, tick), emitted));
    }
  }
}

void Conservation::check_drives(Cycles now) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int64_t drive = plant_.drive_pulses(axis).value();
    const std::int64_t dropped = plant_.dropped_pulses(axis).value();
    const std::int64_t ignored = plant_.ignored_pulses(axis).value();
    if (pins_[axis] != drive + dropped + ignored) {
      report(triggers_, axis, now,
             fmt::format("{} pulses on the pins, the drive counted {}, lost {} and ignored {}", pins_[axis], drive,
                         dropped, ignored));
    }
    const bool enabled = (((servo_was_off_ | plant_.inputs().drive_alarm) >> axis) & 1) == 0;
    const bool may_ignore = !enabled || plant_.drop_out_open();
    if (ignored != ignored_at_trigger_[axis] && !may_ignore) {
      report(triggers_, axis, now,
             fmt::format("the drive ignored {} pulses with its servo on", ignored - ignored_at_trigger_[axis]));
    }
    ignored_at_trigger_[axis] = ignored;
  }
}

// ---- bus ----

void Conservation::on_write(Cycles now, std::uint32_t addr, std::uint32_t data) {
  if (paper_) {
    on_paper_write(now, addr, data);
  } else if (is_block(addr, regs::soc::kPulseTrainBase, regs::soc::kPulseTrainSize)) {
    const std::uint32_t offset = addr - regs::soc::kPulseTrainBase;
    if (offset == pt::kCommitOffset) commit(now);
    if (const auto axis = element(offset, pt::kCountOffset, pt::kCountStride, pt::kCountCount)) {
      staged_[*axis] = regs::extract_signed(data, pt::kCountValue);
    }
  }
  if (addr == regs::soc::kEncoderBase + en::kDebounceOffset) {
    positions_.set_debounce(regs::extract(data, en::kDebounceTime));
  }
}

void Conservation::on_paper_write(Cycles now, std::uint32_t addr, std::uint32_t data) {
  if (addr == regs::soc::kEncoderSwitchBase + regs::encoder_switch::kSelectOffset) {
    selected_ = regs::extract(data, regs::encoder_switch::kSelectAxis);
    switched_ = switched_ || triggers_ > 0;
  }
  if (!is_block(addr, regs::soc::kPulseWidthBase, regs::soc::kPulseWidthSize)) return;
  const std::uint32_t offset = addr - regs::soc::kPulseWidthBase;
  if (const auto axis = element(offset, pw::kWidthOffset, pw::kWidthStride, pw::kWidthCount)) {
    widths_.on_write(*axis, regs::extract_signed(data, pw::kWidthValue), trigger_in_doubt(now));
  }
}

void Conservation::on_paper_read(Cycles now, std::uint32_t addr, std::uint32_t data) {
  if (addr == regs::soc::kPulseWidthBase + pw::kStatusOffset) check_stop(now, (data & pw::kStatusEstopMask) != 0);
  if (addr == regs::soc::kEncoderBase + en::kPositionOffset && selected_ < kAxes && !switched_) {
    check_position(now, selected_, data);
  }
  if (!is_block(addr, regs::soc::kPulseWidthBase, regs::soc::kPulseWidthSize)) return;
  const std::uint32_t offset = addr - regs::soc::kPulseWidthBase;
  if (const auto axis = element(offset, pw::kEmittedOffset, pw::kEmittedStride, pw::kEmittedCount)) {
    check_emitted(now, *axis, data);
  }
}

void Conservation::commit(Cycles now) {
  CountSet set;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    set[axis] = std::clamp(staged_[axis], -kMaxPulsesPerTick, kMaxPulsesPerTick);
  }
  pending_.assign(1, set);
  pending_may_be_active_ = trigger_in_doubt(now);
  if (pending_may_be_active_) active_.push_back(set);
}

void Conservation::on_read(Cycles now, std::uint32_t addr, std::uint32_t data) {
  if (paper_) {
    on_paper_read(now, addr, data);
  } else if (is_block(addr, regs::soc::kPulseTrainBase, regs::soc::kPulseTrainSize)) {
    const std::uint32_t offset = addr - regs::soc::kPulseTrainBase;
    if (offset == pt::kFaultOffset) check_stop(now, (data & kStopFlags) != 0);
    if (offset == pt::kStatusOffset && (data & kStopStates) != 0) explain_shortage(now);
    if (const auto axis = element(offset, pt::kEmittedOffset, pt::kEmittedStride, pt::kEmittedCount)) {
      check_emitted(now, *axis, data);
    }
  } else if (is_block(addr, regs::soc::kEncoderBase, regs::soc::kEncoderSize)) {
    const std::uint32_t offset = addr - regs::soc::kEncoderBase;
    if (const auto axis = element(offset, en::kPositionOffset, en::kPositionStride, en::kPositionCount)) {
      check_position(now, *axis, data);
    }
  }
}

void Conservation::check_stop(Cycles now, bool stopped) {
  if (stopped) {
    explain_shortage(now);
  } else if (shortage_ && logic_time(now) - shortage_->logic_time > access_tail_) {
    report(*shortage_);
  }
}

void Conservation::explain_shortage(Cycles now) {
  stop_seen_ = logic_time(now);
  shortage_.reset();
}

void Conservation::check_emitted(Cycles now, std::size_t axis, std::uint32_t value) {
  const auto shows = [axis, value](const PerAxis<std::int64_t>& emitted) {
    return value == static_cast<std::uint32_t>(emitted[axis]);
  };
  if (!shows(latest_emitted_) && !(trigger_in_doubt(now) && shows(previous_emitted_))) report_emitted(now, axis, value);
}

void Conservation::report_emitted(Cycles now, std::size_t axis, std::uint32_t value) {
  report(triggers_ - 1, axis, now,
         fmt::format("EMITTED reads {}, {} pulses were on the pins at the trigger", static_cast<std::int32_t>(value),
                     latest_emitted_[axis]));
}

void Conservation::check_position(Cycles now, std::size_t axis, std::uint32_t value) {
  if (positions_.accepts(axis, value, trigger_in_doubt(now)) || has_bit(false_encoders_, axis)) return;
  report_position(now, axis, value);
}

void Conservation::report_position(Cycles now, std::size_t axis, std::uint32_t value) {
  const auto& [min, max] = positions_.latest(axis);
  report(triggers_ - 1, axis, now,
         fmt::format("POSITION reads {}, the encoder showed {} .. {} counts before the trigger",
                     static_cast<std::int32_t>(value), min.value(), max.value()));
}

// ---- verdicts ----

void Conservation::finish() {
  if (!shortage_) return;
  // The software had no time to read the reason of a shortage in the last tick. A stop is visible at the servo enable.
  const bool too_recent = triggers_ - shortage_->tick <= 1;
  const bool stopped = ((servo_on_ >> shortage_->axis) & 1) == 0;
  if (!too_recent && !stopped) report(*shortage_);
}

void Conservation::report(const Shortage& shortage) {
  report(shortage.tick, shortage.axis, shortage.cycle,
         fmt::format("{} pulses committed, {} emitted, and {}", shortage.committed, shortage.emitted,
                     paper_ ? "STATUS shows no ESTOP" : "FAULT shows no RESIDUAL, ESTOP or WATCHDOG"));
}

void Conservation::report(std::int64_t tick, std::size_t axis, Cycles cycle, const std::string& what) {
  if (violation_ || !checks_) return;
  violation_ = fmt::format("conservation: tick {}, axis {}, cycle {}: {}", tick, axis + 1, cycle.value(), what);
}

}  // namespace armature::cosim
