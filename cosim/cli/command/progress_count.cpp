#include "cosim/cli/command/progress_count.hpp"

#include <fmt/format.h>

#include <iostream>
#include <utility>

#include "cosim/report/format/progress_bar.hpp"

namespace armature::cosim {

ProgressCount::ProgressCount(std::size_t total, std::string name, bool quiet)
    : total_{total}, name_{std::move(name)}, shown_{!quiet && stderr_is_terminal()} {}

ProgressCount::~ProgressCount() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
}

std::function<void(std::size_t)> ProgressCount::listener() const {
  if (!shown_) return {};
  return [this](std::size_t done) { std::cerr << fmt::format("\r{} of {} {}", done, total_, name_) << std::flush; };
}

}  // namespace armature::cosim
