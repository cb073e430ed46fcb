#include "cosim/rewind/wave_snapshots.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "controller/base/timebase.hpp"
#include "cosim/golden/golden.hpp"
#include "cosim/report/judge/expect.hpp"
#include "cosim/time/never.hpp"

namespace armature::cosim {
namespace {

// From the start of a difference until it is seen: the rows of a golden are so far apart.
constexpr Cycles kSeenLate{kGoldenEveryTicks * armature::kTickCycles.value()};

// Of a copy that has written the waveform.
struct SpanWritten {
  Cycles until{};
  std::array<char, 500> error{};  // '\0' ended; empty: none
};

// The oldest snapshot is always older than the start of a waveform.
std::size_t snapshots_for(Cycles before, Cycles every) {
  const std::int64_t back = (before + std::max(every, kSeenLate)).value();
  return static_cast<std::size_t>(back / every.value()) + 2;
}

}  // namespace

WaveSnapshots::WaveSnapshots(Parts parts, MomentWaveRequest request)
    : parts_{std::move(parts)},
      wanted_{request.wanted},
      output_{std::move(request.output)},
      every_{std::max(kEvery, wanted_.before)},
      kept_{snapshots_for(wanted_.before, every_)},
      so_far_{summary_before_run(parts_.scenario)} {}

void WaveSnapshots::after_step() {
  if (parts_.run.now() < next_) return;
  next_ = parts_.run.now() + every_;
  look_for_moments();
  if (!chosen_) take();
}

void WaveSnapshots::look_for_moments() {
  switch (wanted_.reason) {
    case WaveReason::kFault:
      so_far_.facts.faults = parts_.run.faults();
      break;
    case WaveReason::kFail:
      so_far_.expect_failures = check(parts_.scenario.expect, parts_.run.facts());
      break;
    case WaveReason::kMismatch:
      if (parts_.golden != nullptr) so_far_.golden.begins = parts_.golden->difference();
      break;
  }
  for (const WaveMoment& moment : wave_moments(wanted_, so_far_)) {
    Pin& pin = pins_[moment.what];
    if (pin.snapshot && pin.from == moment.from) continue;
    pin = {moment.from, latest_before(span_of(wanted_, moment).from)};
    // What fails so far may be met in the end.
    if (wanted_.reason != WaveReason::kFail) order(moment);
  }
}

void WaveSnapshots::take() {
  try {
    auto taken = take_snapshot();
    if (auto* woken = std::get_if<WokenCopy>(&taken)) write_in_copy(*woken);
    latest_.push_back(std::make_shared<Snapshot>(Snapshot{parts_.run.now(), std::move(std::get<WaitingCopy>(taken))}));
  } catch (const std::runtime_error&) {
    next_ = kNever;  // the host allows no more
  }
  ending_.reset();
  if (latest_.size() <= kept_) return;
  if (latest_.front().use_count() == 1) latest_.front()->copy.end();
  ending_ = std::move(latest_.front());
  latest_.pop_front();
}

void WaveSnapshots::write_in_copy(WokenCopy& woken) {
  SpanWritten written;
  try {
    written.until = write_span(parts_.run, woken.order<WaveSpan>(), output_, parts_.stop_requested);
  } catch (const std::exception& error) {
    std::string_view{error.what()}.copy(written.error.data(), written.error.size() - 1);
  }
  woken.end(written);
}

void WaveSnapshots::order(const WaveMoment& moment) {
  const WaveSpan span = span_of(wanted_, moment);
  const auto pin = pins_.find(moment.what);
  const bool pinned = pin != pins_.end() && pin->second.snapshot && pin->second.from == moment.from;
  chosen_ = pinned ? pin->second.snapshot : latest_before(span.from);
  if (!chosen_ || !chosen_->copy.wake(span)) return;
  ordered_ = moment;
  next_ = kNever;
  latest_.clear();
}

std::optional<Cycles> WaveSnapshots::write(const WaveMoment& moment) {
  if (!chosen_) order(moment);
  if (!chosen_) return std::nullopt;
  const auto written = chosen_->copy.answer<SpanWritten>();
  if (!written) return std::nullopt;
  if (written->error[0] != '\0') throw std::runtime_error{written->error.data()};
  return written->until;
}

std::shared_ptr<WaveSnapshots::Snapshot> WaveSnapshots::latest_before(Cycles at) const {
  const auto found =
      std::ranges::find_if(latest_.rbegin(), latest_.rend(), [at](const auto& one) { return one->at <= at; });
  return found == latest_.rend() ? nullptr : *found;
}

}  // namespace armature::cosim
