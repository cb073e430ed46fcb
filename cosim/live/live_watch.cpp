#include "cosim/live/live_watch.hpp"

#include <fmt/format.h>
#include <spdlog/details/null_mutex.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/base_sink.h>

#include <utility>
#include <variant>

#include "controller/base/timebase.hpp"
#include "cosim/report/format/injection_text.hpp"
#include "cosim/run/event_log.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/fault_text.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

// Keeps the last lines of a log.
class LastLines final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 public:
  // `tick`: of each line.
  LastLines(std::deque<std::string>& lines, const std::int64_t& tick) : lines_{lines}, tick_{tick} {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t text;
    formatter_->format(message, text);
    std::string line = fmt::format("tick {}, ", tick_) + std::string{text.data(), text.size()};
    while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
    lines_.push_back(std::move(line));
    if (lines_.size() > LiveWatch::kMaxEvents) lines_.pop_front();
  }
  void flush_() override {}

  std::deque<std::string>& lines_;
  const std::int64_t& tick_;
};

std::string command_of(const Event& event, const std::string& before) {
  if (const auto* move = std::get_if<MoveStarted>(&event)) {
    return fmt::format("{} move of {:.2f} s", word_of(move->kind),
                       static_cast<double>(move->duration.value()) * kTickSeconds);
  }
  if (std::holds_alternative<JogStarted>(event)) return "jog";
  if (const auto* axis = std::get_if<HomingStarted>(&event)) return fmt::format("homing of axis {}", axis->axis);
  const bool ends = std::holds_alternative<MoveFinished>(event) || std::holds_alternative<JogEnded>(event) ||
                    std::holds_alternative<HomingEnded>(event) || std::holds_alternative<Faulted>(event);
  return ends ? std::string{} : before;
}

// What is held until it is let go has a day as its duration.
std::string text_of(const FaultSpec& fault) {
  const bool held = fault_duration_s(fault.kind) == kMaxDurationS;
  std::string text = fault_text(fault);
  if (held) text.erase(text.rfind(" for "));
  return held ? text + ", held" : text;
}

}  // namespace

struct LiveWatch::Log {
  Log(const Scenario& scenario, std::deque<std::string>& lines)
      : names{scenario}, log{"live", std::make_shared<LastLines>(lines, tick)} {
    log.set_pattern("%l: %v");
  }

  void write(const FaultSpec& fault, Cycles at) { log.warn("{} fault: {}", stamp(at), text_of(fault)); }
  void write(const FaultEnd& end, Cycles at) { log.info("{} fault ends: {}", stamp(at), text_of(end.fault)); }
  void write(const InputSpec& input, Cycles at) { log.info("{} input: {}", stamp(at), input_text(input)); }
  void write(const CommandSpec&, Cycles) {}  // its events are written
  void write(const StreamStep&, Cycles) {}
  void write(const PartStep&, Cycles) {}

  std::int64_t tick = 0;

  CommandNames names;
  spdlog::logger log;
  EventLog events{log, names};
};

LiveWatch::LiveWatch(const Scenario& scenario) : log_{std::make_unique<Log>(scenario, events_)} {}
LiveWatch::~LiveWatch() = default;

void LiveWatch::on_row(const TraceRow& row, const IntegerDigest&) {
  telemetry_ = row.telemetry;
}

void LiveWatch::on_event(const Event& event, const RunPlace& place) {
  command_ = command_of(event, command_);
  log_->tick = place.tick;
  log_->events.write(event, place.at);
}

void LiveWatch::on_action(const ScriptAction& action, const RunPlace& place) {
  log_->tick = place.tick;
  std::visit([&](const auto& what) { log_->write(what, place.at); }, action);
}

}  // namespace armature::cosim
