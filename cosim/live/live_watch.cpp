#include "cosim/live/live_watch.hpp"

#include <fmt/format.h>
#include <spdlog/details/null_mutex.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/base_sink.h>

#include <utility>
#include <variant>

#include "controller/base/timebase.hpp"
#include "cosim/run/event_log.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

// Keeps the last lines of a log.
class LastLines final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 public:
  explicit LastLines(std::deque<std::string>& lines) : lines_{lines} {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t text;
    formatter_->format(message, text);
    std::string line{text.data(), text.size()};
    while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
    lines_.push_back(std::move(line));
    if (lines_.size() > LiveWatch::kMaxEvents) lines_.pop_front();
  }
  void flush_() override {}

  std::deque<std::string>& lines_;
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

}  // namespace

struct LiveWatch::Log {
  Log(const Scenario& scenario, std::deque<std::string>& lines)
      : names{scenario}, log{"live", std::make_shared<LastLines>(lines)} {
    log.set_pattern("%l: %v");
  }

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
  log_->events.write(event, place.at);
}

}  // namespace armature::cosim
