// The values that a fact of a run can have.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cosim/report/measure/path_error.hpp"
#include "cosim/report/measure/run_events.hpp"

namespace armature::cosim {

// One value for each axis that the robot has.
template <class T>
struct OfAxes {
  std::vector<T> values;
};

// Of the tool centre point, in the base frame.
struct Point {
  Eigen::Vector3d mm;
};
struct Orientation {
  Eigen::Matrix3d rotation;
  std::array<double, 3> rpy_deg{};  // roll, pitch and yaw of `rotation`, as written in the scenario or as measured
};

// What the controller sent on the serial line.
struct SerialText {
  std::string bytes;
  std::int64_t errors = 0;  // bytes with an error, and breaks
  bool as_hex = false;      // how messages show it
};

// With the name of its command.
struct NamedDeviation : PathDeviation {
  std::string command;
};

// monostate: the run has no such value.
using FactValue = std::variant<std::monostate, std::int64_t, double, std::string, OfAxes<std::int64_t>, OfAxes<double>,
                               OfAxes<std::string>, std::vector<std::int64_t>, std::vector<std::string>, Point,
                               Orientation, NamedDeviation, SerialText, std::vector<OutputChange>>;

// A value as messages show it; numbers are rounded to six digits after the point. `unit` follows a number that has a
// fraction. Counts are shown without a unit.
[[nodiscard]] std::string value_text(const FactValue& value, std::string_view unit = {});

}  // namespace armature::cosim
