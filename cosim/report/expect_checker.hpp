// How a measured fact is compared with an expected one, and what is said when they differ.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/core/axes.hpp"
#include "cosim/report/expect.hpp"
#include "cosim/report/run_facts.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

inline std::string show(double value) {
  return number_text(std::round(value * 1e6) / 1e6);
}
// What is compared with a limit: small values keep their digits.
inline std::string show_small(double value) {
  return std::fabs(value) < 1e-3 ? number_text(std::stod(fmt::format("{:.3g}", value))) : show(value);
}
inline std::string show(std::int64_t value) {
  return std::to_string(value);
}
inline std::string show(std::string_view value) {
  return std::string{value};
}

template <class Values>
std::string show_list(const Values& values) {
  std::string text = "[";
  for (const auto& value : values) {
    if (text.size() > 1) text += ", ";
    text += show(value);
  }
  return text += "]";
}

// The axes that the robot has.
template <class T>
std::span<const T> of_axes(const PerAxis<T>& values, std::size_t axis_count) {
  return std::span{values}.first(axis_count);
}

// Collects what is not met. Nothing is compared where nothing is expected.
class Checker {
 public:
  explicit Checker(std::size_t axis_count) : axis_count_{axis_count} {}

  void require(bool met, std::string_view key, std::string expected, std::string got) {
    if (!met) failures_.push_back({std::string{key}, std::move(expected), std::move(got)});
  }

  template <class T>
  void exactly(std::string_view key, const std::optional<T>& expected, const T& got) {
    if (expected) require(*expected == got, key, show(*expected), show(got));
  }

  template <class Values>
  void list_exactly(std::string_view key, const std::optional<Values>& expected, const Values& got) {
    if (expected) require(*expected == got, key, show_list(*expected), show_list(got));
  }

  template <class T>
  void axes_exactly(std::string_view key, const std::optional<PerAxis<T>>& expected, const PerAxis<T>& got) {
    if (!expected) return;
    const std::span<const T> wanted = of_axes(*expected, axis_count_);
    const std::span<const T> found = of_axes(got, axis_count_);
    require(std::ranges::equal(wanted, found), key, show_list(wanted), show_list(found));
  }

  void axes_near(std::string_view key, const std::optional<PerAxis<double>>& expected, double tolerance,
                 const PerAxis<double>& got) {
    if (!expected) return;
    const std::span<const double> wanted = of_axes(*expected, axis_count_);
    const std::span<const double> found = of_axes(got, axis_count_);
    const bool met =
        std::ranges::equal(found, wanted, [&](double a, double b) { return std::fabs(a - b) <= tolerance; });
    require(met, key, show_list(wanted) + " +-" + number_text(tolerance), show_list(found));
  }

  // None: there was nothing to measure.
  void deviation_at_most(std::string_view key, std::optional<double> expected,
                         const std::optional<PathDeviation>& got) {
    if (!expected) return;
    require(got && got->mm <= *expected, key, "at most " + number_text(*expected) + " mm",
            got ? fmt::format("{} mm at tick {} in move[{}]", show_small(got->mm), got->tick, got->move)
                : "no move on a line or an arc that was measured");
  }

  void at_least(std::string_view key, std::optional<std::int64_t> expected, std::int64_t got) {
    if (expected) require(got >= *expected, key, "at least " + show(*expected), show(got));
  }

  void at_most(std::string_view key, std::optional<std::int64_t> expected, std::int64_t got) {
    if (expected) require(got <= *expected, key, "at most " + show(*expected), show(got));
  }

  [[nodiscard]] std::vector<ExpectFailure> take() { return std::move(failures_); }

 private:
  std::size_t axis_count_;
  std::vector<ExpectFailure> failures_;
};

}  // namespace armature::cosim
