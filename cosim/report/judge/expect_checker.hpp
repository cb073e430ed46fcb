// How a measured fact is compared with an expected one, and what is said when they differ.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/core/axes.hpp"
#include "cosim/report/judge/expect.hpp"
#include "cosim/report/judge/expect_where.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

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
  Checker(const ExpectSpec& expect, std::size_t axis_count) : expect_{expect}, axis_count_{axis_count} {}

  void require(bool met, std::string_view key, std::string expected, std::string got, ExpectWhere where = {}) {
    if (met) return;
    const auto origin = expect_.origins.find(key);
    failures_.push_back({.key = std::string{key},
                         .expected = std::move(expected),
                         .got = std::move(got),
                         .where = std::move(where),
                         .file = expect_.file,
                         .origin = origin == expect_.origins.end() ? Origin{} : origin->second});
  }

  template <class T>
  void exactly(std::string_view key, const std::optional<T>& expected, const T& got, ExpectWhere where = {}) {
    if (expected) require(*expected == got, key, show(*expected), show(got), std::move(where));
  }

  template <class Values>
  void list_exactly(std::string_view key, const std::optional<Values>& expected, const Values& got,
                    ExpectWhere where = {}) {
    if (expected) require(*expected == got, key, show_list(*expected), show_list(got), std::move(where));
  }

  template <class T>
  void axes_exactly(std::string_view key, const std::optional<PerAxis<T>>& expected, const PerAxis<T>& got) {
    if (!expected) return;
    axes(key, of_axes(*expected, axis_count_), of_axes(got, axis_count_), "",
         [](const T& a, const T& b) { return std::fabs(static_cast<double>(b - a)); });
  }

  // `tolerance_key`: that of `tolerance`.
  void axes_near(std::string_view key, const std::optional<PerAxis<double>>& expected, double tolerance,
                 std::string_view tolerance_key, const PerAxis<double>& got,
                 const PerAxis<std::optional<FactPlace>>& places = {}) {
    if (!expected) return;
    axes(
        key, of_axes(*expected, axis_count_), of_axes(got, axis_count_), plus_minus(tolerance, tolerance_key),
        [&](double a, double b) {
          const double size = std::fabs(b - a);
          return size <= tolerance ? 0.0 : std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
        },
        of_axes(places, axis_count_));
  }

  // A word for each axis.
  void axes_words(std::string_view key, const std::vector<std::string>& expected, const std::vector<std::string>& got) {
    if (expected.size() != got.size()) {
      require(false, key, show_list(expected), show_list(got));
      return;
    }
    axes(key, std::span{expected}, std::span{got}, "",
         [](const std::string& a, const std::string& b) { return a == b ? 0.0 : 1.0; });
  }

  // None: there was nothing to measure.
  void deviation_at_most(std::string_view key, std::optional<double> expected,
                         const std::optional<PathDeviation>& got) {
    if (!expected) return;
    std::optional<FactPlace> place;
    if (got) place = FactPlace{.tick = got->tick, .at = got->at};
    require(got && got->mm <= *expected, key, "at most " + number_text(*expected) + " mm",
            got ? fmt::format("{} mm in move[{}]", show_small(got->mm), got->move)
                : "no move on a line or an arc that was measured",
            at_place(place));
  }

  void at_least(std::string_view key, std::optional<std::int64_t> expected, std::int64_t got) {
    if (expected) require(got >= *expected, key, "at least " + show(*expected), show(got));
  }

  void at_most(std::string_view key, std::optional<std::int64_t> expected, std::int64_t got,
               const std::optional<FactPlace>& place) {
    if (expected) require(got <= *expected, key, "at most " + show(*expected), show(got), at_place(place));
  }

  // ` +-0.001`, and the `--set` that it is from.
  [[nodiscard]] std::string plus_minus(double tolerance, std::string_view key) const {
    const auto origin = expect_.origins.find(key);
    const bool given = origin != expect_.origins.end() && !origin->second.override_text.empty();
    return " +-" + number_text(tolerance) + (given ? " (" + place_text(expect_.file, origin->second) + ")" : "");
  }

  [[nodiscard]] std::vector<ExpectFailure> take() { return std::move(failures_); }

 private:
  // `off` as of at_axes().
  template <class T, class Off>
  void axes(std::string_view key, std::span<const T> wanted, std::span<const T> found, const std::string& tolerance,
            Off off, std::span<const std::optional<FactPlace>> places = {}) {
    ExpectWhere where = at_axes(wanted, found, off, places);
    const bool met = where.axes.empty();
    require(met, key, show_list(wanted) + tolerance, show_list(found), std::move(where));
  }

  const ExpectSpec& expect_;
  std::size_t axis_count_;
  std::vector<ExpectFailure> failures_;
};

}  // namespace armature::cosim
