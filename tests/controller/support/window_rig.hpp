// Executes a long path in windows, as core 0 does, and collects its set-points.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "controller/trajectory/run/sampler.hpp"
#include "tests/controller/support/finish_plan.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

struct WindowRun {
  std::vector<JointAngles> joints;               // at every tick, with rest before and after
  std::vector<std::size_t> switches;             // elements of `joints` at which another window began
  std::size_t rests = 0;                         // ends of windows that nothing continued, the last one included
  std::size_t refused = 0;                       // windows that could not continue
  std::size_t late = 0;                          // windows that came too late
  std::int64_t inverses = 0, most_inverses = 0;  // of windows that continue another one
  std::size_t windows = 0, largest = 0;          // the same; the number, and segments
  bool complete = false;
};

class WindowRig {
 public:
  // A window is asked for when it has room for `least` further segments, or for all that are there, and begins `lead`
  // ticks later.
  WindowRig(PathRig& rig, std::vector<SegmentRequest> requests, std::int64_t lead, std::size_t least)
      : rig_{rig}, requests_{std::move(requests)}, lead_{lead}, least_{least} {}

  // How many of the requests are there at a tick, the wanted rate, and how long the planning of a window takes.
  std::function<std::size_t(std::int64_t)> supplied = [this](std::int64_t) { return requests_.size(); };
  std::function<double(std::int64_t)> rate = [](std::int64_t) { return 1.0; };
  std::function<std::int64_t()> planning_ticks = [] { return std::int64_t{0}; };

  [[nodiscard]] WindowRun run(const JointAngles& start, std::int64_t most_ticks) {
    result_ = {};
    result_.joints.assign(4, start);
    sampler_.reset_to(start);
    next_ = 0;
    pending_ = dead_ = false;
    for (tick_ = 0; tick_ < most_ticks && !result_.complete; ++tick_) step();
    for (int i = 0; i < 4; ++i) result_.joints.push_back(result_.joints.back());
    return result_;
  }

 private:
  void step() {
    const std::size_t there = std::min(supplied(tick_), requests_.size());
    if (!sampler_.busy() && there > next_) begin(there);
    if (sampler_.busy() && !pending_ && !dead_ && there > next_) extend(there);
    if (pending_ && tick_ >= ready_tick_) take_next();
    const bool was_busy = sampler_.busy();
    result_.joints.push_back(sampler_.advance(rate(tick_)));
    if (!was_busy || sampler_.busy()) return;
    if (pending_) drop_next();
    ++result_.rests;
    result_.complete = next_ == requests_.size();
  }

  void begin(std::size_t there) {
    const std::size_t count = std::min(there - next_, CartesianPlan::kMaxFirstSegments);
    ASSERT_EQ(rig_.plan(result_.joints.back(), chain(next_, count)), CartesianPlanner::Progress::kDone) << next_;
    *plan_ = rig_.planner.plan();
    next_ += count;
    sampler_.start(Plan{Piece{*plan_}}, rate(tick_));
    dead_ = false;
  }

  void extend(std::size_t there) {
    const Ticks earliest{static_cast<std::int64_t>(sampler_.elapsed()) + lead_};
    const std::size_t wanted = std::min(there - next_, rig_.planner.room(earliest));
    if (wanted == 0 || wanted < std::min(least_, there - next_)) return;
    if (!rig_.planner.extend(earliest, requests_[next_ - 1].blend_mm, chain(next_, wanted))) return;
    if (finish_plan(rig_.planner) != CartesianPlanner::Progress::kDone) {
      ++result_.refused;
      dead_ = true;
      return;
    }
    *next_plan_ = rig_.planner.plan();
    result_.inverses += rig_.planner.inverses();
    result_.most_inverses = std::max(result_.most_inverses, rig_.planner.inverses());
    ++result_.windows;
    result_.largest = std::max(result_.largest, rig_.planner.plan().count);
    added_ = wanted;
    next_ += wanted;
    pending_ = true;
    ready_tick_ = tick_ + planning_ticks();
  }

  void take_next() {
    const CartesianPlan& next = *next_plan_;
    if (sampler_.missed(next)) {
      drop_next();
    } else if (sampler_.can_continue_with(next)) {
      sampler_.continue_with(next);
      std::swap(plan_, next_plan_);
      pending_ = false;
      result_.switches.push_back(result_.joints.size());
    }
  }

  // Its segments follow after the stop.
  void drop_next() {
    next_ -= added_;
    ++result_.late;
    pending_ = false;
    dead_ = true;
  }

  // The last one without a blend: its corner follows with the next window.
  [[nodiscard]] std::span<const SegmentRequest> chain(std::size_t first, std::size_t count) {
    chain_.assign(requests_.begin() + static_cast<std::ptrdiff_t>(first),
                  requests_.begin() + static_cast<std::ptrdiff_t>(first + count));
    chain_.back().blend_mm = 0.0;
    return chain_;
  }

  PathRig& rig_;
  std::vector<SegmentRequest> requests_, chain_;
  std::int64_t lead_;
  std::size_t least_;
  Sampler sampler_{rig_.robot, rig_.arm, {}};
  WindowRun result_;
  std::unique_ptr<CartesianPlan> plan_ = std::make_unique<CartesianPlan>(),
                                 next_plan_ = std::make_unique<CartesianPlan>();
  std::size_t next_ = 0, added_ = 0;
  std::int64_t tick_ = 0, ready_tick_ = 0;
  bool pending_ = false, dead_ = false;  // dead: nothing can continue the active plan
};

}  // namespace armature::test
