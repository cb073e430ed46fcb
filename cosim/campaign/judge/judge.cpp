#include "cosim/campaign/judge/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <variant>

#include "controller/base/timebase.hpp"
#include "controller/base/words.hpp"
#include "cosim/fault/fault_spec.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kPathTicks = 20;    // between two searches of the path
constexpr std::size_t kOffTicks = 1'000;  // without power, after which nothing more happens
constexpr std::size_t kEndTicks = 2'000;  // the same at the end of the path: an elastic arm may swing as long
constexpr std::int64_t kLostCounts = 3;   // of an arm that is as good as at rest
constexpr std::int64_t kLeastPulses = 1;  // that a pulse in progress may still end
constexpr Cycles kOffIn{14 * armature::kTickCycles.value()};  // an emergency stop, or by the relay of drop_out_us

}  // namespace

void CampaignJudge::detect(Cycles at) {
  if (!detected_) detected_ = at;
}

void CampaignJudge::add(Outcome outcome, std::string reason) {
  if (!first_error_) first_error_ = {outcome, std::move(reason)};
}

void CampaignJudge::on_event(const Event& event, const RunPlace& place) {
  if (std::holds_alternative<MoveRefused>(event)) ++refusals_;
  if (const auto* note = std::get_if<ProgramNoted>(&event)) {
    program_failed_ =
        program_failed_ || note->kind == ProgramNoted::Kind::kAlarm || note->kind == ProgramNoted::Kind::kStopped;
  }
  const auto* fault = std::get_if<Faulted>(&event);
  if (fault == nullptr || fault->cause == FaultCause::kNone || fault->cause == FaultCause::kDrivesOff) return;
  reported_.push_back({fault->cause, fault->axis, place.at});
  detect(place.at);
}

void CampaignJudge::on_action(const ScriptAction& action, const RunPlace& place) {
  const auto* fault = std::get_if<FaultSpec>(&action);
  if (fault == nullptr) return;
  const bool strong = is_strong_push(fault->kind);
  begun_.push_back({place.at, strong ? 0 : fault_axis(fault->kind).value_or(0)});
  if (std::holds_alternative<Estop>(fault->kind) && !estop_) estop_ = place.at;
  if (!strong) return;
  was_pushed_ = true;
  push_end_ = std::max(push_end_.value_or(Cycles{}), place.at + to_cycles(*fault_duration_s(fault->kind)));
}

// Of a joint whose brake or drive does not hold it. The links pass the push on to all axes.
bool CampaignJudge::is_strong_push(const FaultKind& kind) const {
  const auto* push = std::get_if<CollisionTorque>(&kind);
  if (push == nullptr) return false;
  return std::fabs(push->torque_nm) > limits_.axes.at(static_cast<std::size_t>(push->axis - 1)).withstood_nm;
}

// No controller holds an arm against a push that is stronger than its brakes. Its motion is judged again when the push
// is over and the arm has come to rest. What the controller detects, and the pulses, are always judged.
bool CampaignJudge::is_pushed(Cycles now) {
  if (push_end_ && now > *push_end_ && rest_rows_ > kRestRows) push_end_.reset();
  return push_end_.has_value();
}

void CampaignJudge::on_signal(const Signal& signal, const RunPlace& place) {
  if (const auto* servos = std::get_if<ServoEnables>(&signal)) see_power(servos->levels, place.at);
  if (std::holds_alternative<BusAbort>(signal)) detect(place.at);
}

void CampaignJudge::see_power(std::uint8_t levels, Cycles at) {
  if ((servo_on_ & ~levels) != 0 && was_on_) detect(at);
  servo_on_ = levels;
  if (levels != 0 && power_off_) add(Outcome::kMotionAfterStop, "the servo power came back without a reset");
  if (levels == 0 && was_on_ && !power_off_) power_off_ = at;
  was_on_ = was_on_ || levels != 0;
}

void CampaignJudge::on_row(const TraceRow& row, const IntegerDigest&) {
  const TruePoint now{row.cycle, row.motor_counts, row.pin_pulses, servo_on_};
  if (row.telemetry.underruns != underruns_) detect(Cycles{row.cycle});
  underruns_ = row.telemetry.underruns;
  compare(now);
  const bool pushed = is_pushed(Cycles{row.cycle});
  if (!pushed) check_speed(now);
  // Without power an arm stays where a push has left it.
  if (!pushed && !(was_pushed_ && power_off_)) check_range(now);
  if (power_off_) {
    check_without_power(now, pushed);
  } else if (!detected_ && rows_ % kPathTicks == 0) {
    check_path(now);
  }
  rest_rows_ = rows_ > 0 && now.motor_counts == last_.motor_counts ? rest_rows_ + 1 : 0;
  at_end_rows_ = is_end(now.motor_counts) ? at_end_rows_ + 1 : 0;
  off_rows_ = power_off_ ? off_rows_ + 1 : 0;
  for (std::size_t i = 0; i < kAxes; ++i) known_counts_[i] = row.telemetry.encoder[i].value();
  before_[rows_ % kSpeedTicks] = now;
  last_ = now;
  ++rows_;
}

void CampaignJudge::compare(const TruePoint& now) {
  if (!identical_ || path_.points.empty()) return;
  if (rows_ < path_.points.size()) {
    identical_ = now == path_.points[rows_];
    return;
  }
  const TruePoint& end = path_.points.back();
  identical_ = now.motor_counts == end.motor_counts && now.pin_pulses == end.pin_pulses && now.servo_on == end.servo_on;
}

bool CampaignJudge::is_end(const PerAxis<std::int64_t>& counts) const {
  if (path_.points.empty()) return true;
  const TruePoint& end = path_.points.back();
  for (std::size_t i = 0; i < limits_.axis_count; ++i) {
    if (std::abs(counts[i] - end.motor_counts[i]) > limits_.axes[i].tolerance_counts) return false;
  }
  return true;
}

bool CampaignJudge::near_path(const TruePoint& now) const {
  const auto is_near = [&](const TruePoint& point) {
    for (std::size_t i = 0; i < limits_.axis_count; ++i) {
      if (std::abs(now.motor_counts[i] - point.motor_counts[i]) > limits_.axes[i].off_path_counts) return false;
    }
    return true;
  };
  if (path_.points.empty()) return true;
  if (is_near(path_.points[std::min(rows_, path_.points.size() - 1)])) return true;
  return std::ranges::any_of(path_.points, is_near);
}

void CampaignJudge::check_path(const TruePoint& now) {
  if (!identical_ && !near_path(now)) add(Outcome::kTooLate, "the arm left its path, and nothing was detected");
}

void CampaignJudge::check_speed(const TruePoint& now) {
  if (rows_ < kSpeedTicks) return;
  const TruePoint& before = before_[rows_ % kSpeedTicks];
  // While the clock of the logic stands there are no rows, but the motors turn.
  const double ticks =
      static_cast<double>(now.cycle - before.cycle) / static_cast<double>(armature::kTickCycles.value());
  for (std::size_t i = 0; i < limits_.axis_count; ++i) {
    const auto counts = static_cast<double>(std::abs(now.motor_counts[i] - before.motor_counts[i]));
    if (counts > limits_.axes[i].max_counts_per_tick * ticks) {
      add(Outcome::kLimitExceeded, fmt::format("axis {} is too fast", i + 1));
    }
  }
}

void CampaignJudge::check_range(const TruePoint& now) {
  for (std::size_t i = 0; i < limits_.axis_count; ++i) {
    const AxisLimits& axis = limits_.axes[i];
    const double deg = static_cast<double>(now.motor_counts[i]) * axis.deg_per_count;
    if (deg < axis.min_deg || deg > axis.max_deg) {
      add(Outcome::kLimitExceeded, fmt::format("axis {} is behind the end of its range", i + 1));
    }
  }
}

void CampaignJudge::check_without_power(const TruePoint& now, bool pushed) {
  constexpr std::size_t kLastPulses = 2;  // ticks
  if (off_rows_ <= kLastPulses || !at_power_off_) {
    at_power_off_ = now;
    return;
  }
  if (pushed) at_power_off_->motor_counts = now.motor_counts;
  for (std::size_t i = 0; i < limits_.axis_count; ++i) {
    if (std::abs(now.pin_pulses[i] - at_power_off_->pin_pulses[i]) > kLeastPulses) {
      add(Outcome::kMotionAfterStop, fmt::format("axis {} gets pulses after the stop", i + 1));
    }
    if (std::abs(now.motor_counts[i] - at_power_off_->motor_counts[i]) > limits_.axes[i].run_out_counts) {
      add(Outcome::kMotionAfterStop, fmt::format("axis {} moves after the stop", i + 1));
    }
  }
}

bool CampaignJudge::may_end() const {
  if (Cycles{last_.cycle} < faults_end_) return false;
  if (power_off_) return off_rows_ > kOffTicks;
  return rows_ > path_.points.size() && at_end_rows_ > kRestRows &&
         (rest_rows_ > kRestRows || at_end_rows_ > kEndTicks);
}

std::optional<CampaignJudge::Error> CampaignJudge::power_error() const {
  const auto is_off_by = [&](Cycles latest) {
    return power_off_ ? *power_off_ <= latest : Cycles{last_.cycle} <= latest;
  };
  if (estop_ && !is_off_by(*estop_ + kOffIn)) return Error{Outcome::kServosOn, "emergency stop"};
  for (const Reported& fault : reported_) {
    if (!is_off_by(fault.at + limits_.brake_time)) {
      return Error{Outcome::kServosOn, fmt::format("after the fault {}", word_of(fault.cause))};
    }
  }
  return std::nullopt;
}

std::optional<CampaignJudge::Error> CampaignJudge::blame_error() const {
  if (detected_ && (begun_.empty() || *detected_ < begun_.front().at)) {
    return Error{Outcome::kWrongFault, "stopped before any fault: " + stop_reason()};
  }
  if (reported_.empty() || reported_.front().axis == 0) return std::nullopt;
  const int blamed = reported_.front().axis;
  const bool right =
      std::ranges::any_of(begun_, [&](const Begun& fault) { return fault.axis == 0 || fault.axis == blamed; });
  if (right) return std::nullopt;
  return Error{Outcome::kWrongFault, stop_reason()};
}

// Of an arm that keeps its servo power.
std::optional<CampaignJudge::Error> CampaignJudge::end_error() const {
  if (!is_end(last_.motor_counts)) {
    if (refusals_ > path_.refusals || program_failed_) return std::nullopt;
    if (is_end(known_counts_)) return Error{Outcome::kWrongPosition, "the controller takes the arm for finished"};
    const bool rests = rest_rows_ > kRestRows;
    return Error{Outcome::kHang, rests ? "the arm stands before its end" : "the arm moves longer than it should"};
  }
  for (std::size_t i = 0; i < limits_.axis_count; ++i) {
    const std::int64_t off = std::abs(known_counts_[i] - last_.motor_counts[i]);
    if (off > kLostCounts) {
      return Error{Outcome::kWrongPosition, fmt::format("axis {}: {} counts are lost", i + 1, off)};
    }
  }
  return std::nullopt;
}

std::optional<CampaignJudge::Error> CampaignJudge::error() const {
  if (std::optional<Error> power = power_error()) return power;
  if (first_error_) return first_error_;
  if (std::optional<Error> blame = blame_error()) return blame;
  return power_off_ ? std::nullopt : end_error();
}

std::string CampaignJudge::stop_reason() const {
  if (reported_.empty()) return "the controller is silent";
  const Reported& first = reported_.front();
  const std::string axis = first.axis == 0 ? "" : fmt::format(" of axis {}", first.axis);
  return std::string{word_of(first.cause)} + axis;
}

std::optional<Cycles> CampaignJudge::detected() const {
  return detected_ && !begun_.empty() && *detected_ >= begun_.front().at ? detected_ : std::nullopt;
}

Verdict CampaignJudge::verdict(const std::optional<std::string>& failure) const {
  Verdict verdict;
  if (const std::optional<Cycles> at = detected()) verdict.latency_ticks = ticks_between(begun_.front().at, *at);
  if (failure) {
    verdict.outcome = Outcome::kFailed;
    verdict.reason = *failure;
  } else if (const std::optional<Error> found = error()) {
    verdict.outcome = found->outcome;
    verdict.reason = found->reason;
  } else if (power_off_) {
    verdict.outcome = Outcome::kStopped;
    verdict.reason = stop_reason();
  } else if (!is_end(last_.motor_counts)) {
    verdict.outcome = Outcome::kStopped;
    verdict.reason = "a command was refused";
  } else if (identical_ && !begun_.empty() && !detected_) {
    verdict.outcome = Outcome::kMasked;
  }
  return verdict;
}

}  // namespace armature::cosim
