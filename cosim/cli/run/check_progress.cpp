#include "cosim/cli/run/check_progress.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cosim/text/printable.hpp"

namespace armature::cosim {

void CheckProgress::begin(const std::string& scenario) {
  running_.push_back(scenario);
  draw();
}

void CheckProgress::end(const std::string& scenario) {
  running_.erase(std::ranges::find(running_, scenario));
  ++done_;
  draw();
}

void CheckProgress::clear() {
  if (drawn_) out_ << "\r\033[K" << std::flush;
  drawn_ = false;
}

void CheckProgress::draw() {
  if (!enabled_) return;
  clear();
  // A line that the terminal would break could not be removed.
  constexpr std::size_t kMaxNames = 50;  // characters
  std::string names;
  for (const std::string& name : running_) names += (names.empty() ? ": " : ", ") + name;
  out_ << fmt::format("{} of {} scenarios{}", done_, total_, printable(names, kMaxNames)) << std::flush;
  drawn_ = true;
}

}  // namespace armature::cosim
