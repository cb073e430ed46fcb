// The outputs of a path, from one plan to the windows that continue it.
//
// A window has the outputs of its segments again. Core 0 may have switched some of them when it begins with the window.
// So outputs in the time in which both plans are the same keep their times and their order, and core 0 continues behind
// the last one that it has switched.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/cartesian/cartesian_plan.hpp"
#include "controller/trajectory/path/path_output.hpp"
#include "controller/trajectory/path/segment_request.hpp"
#include "controller/trajectory/path/timed_outputs.hpp"

namespace armature {

class PlannedOutputs {
 public:
  // A plan from rest has these segments, with at most TimedOutputs::kMax outputs.
  void begin(std::span<const SegmentRequest> chain) noexcept;
  // Sets the outputs of the plan, whose times are set. Returns the first segment with an output that is before the
  // start or behind the end of the plan; those of the plan are not valid then.
  [[nodiscard]] std::optional<std::size_t> place(CartesianPlan& plan) noexcept;

  // Whether all are on their own segments. Only then can the plan be continued.
  [[nodiscard]] bool on_own_segments(const CartesianPlan& plan) const noexcept;
  // How many can be added to a window that has this origin or a later one.
  [[nodiscard]] std::size_t room(Ticks origin) const noexcept;
  // The plan becomes a window without its first `over` segments. Its times are from `origin` on, and it is the same as
  // before until `same_until_ticks` of the plan before. Returns how many outputs were over at `origin`: the first ones
  // of that plan, which the window does not have.
  [[nodiscard]] std::size_t move_origin(Ticks origin, double same_until_ticks, std::size_t over) noexcept;
  // Behind the `count` segments that the window has. There must be room.
  void add(std::size_t count, std::span<const SegmentRequest> segments) noexcept;

 private:
  struct Planned {
    PathOutput output{};
    Tag tag{};
    std::uint16_t segment = 0;
    bool keeps_time = false;
    double ticks = 0.0;
  };

  std::array<Planned, TimedOutputs::kMax> list_{};  // in the order of segments
  std::size_t count_ = 0;
  double same_until_ticks_ = 0.0;
};

}  // namespace armature
