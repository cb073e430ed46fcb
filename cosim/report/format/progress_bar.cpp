#include "cosim/report/format/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace armature::cosim {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};
constexpr int kWidth = 30;
constexpr const char* kClearLine = "\r\033[K";

std::string time_left(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

std::string progress_line(double simulated_s, double total_s, double wall_s) {
  const double done = total_s > 0 ? std::clamp(simulated_s / total_s, 0.0, 1.0) : 1.0;
  const auto filled = static_cast<std::size_t>(done * kWidth);
  std::string line = fmt::format("[{:-<{}}] {:3.0f} %  {:.3f} of {:.3f} s", std::string(filled, '#'), kWidth,
                                 std::floor(done * 100), simulated_s, total_s);
  if (wall_s > 0 && simulated_s > 0) {
    line += fmt::format("  x{:.3f}  {} left", simulated_s / wall_s, time_left(wall_s * (1 - done) / done));
  }
  return line;
}

ProgressBar::ProgressBar(std::ostream& out, double total_s, bool enabled, std::function<Clock::time_point()> now)
    : out_{out}, total_s_{total_s}, enabled_{enabled}, now_{std::move(now)}, start_{now_()}, next_{start_ + kRedraw} {}

ProgressBar::~ProgressBar() {
  if (drawn_) out_ << kClearLine << std::flush;
}

void ProgressBar::update(double simulated_s) {
  if (!enabled_) return;
  const Clock::time_point now = now_();
  if (now < next_) return;
  next_ = now + kRedraw;
  drawn_ = true;
  const double wall_s = std::chrono::duration<double>(now - start_).count();
  out_ << kClearLine << progress_line(simulated_s, total_s_, wall_s) << std::flush;
}

bool stderr_is_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

}  // namespace armature::cosim
