#include "cosim/report/judge/comparison.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "cosim/report/facts/value_text.hpp"
#include "cosim/report/judge/axes_off.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using Places = std::span<const std::optional<RunPlace>>;

// The result of comparing a measured value with the expected one. With empty texts, the texts of the fact are used.
struct Match {
  bool met = false;
  std::string got{};       // instead of the value
  std::string got_also{};  // after the value
  std::optional<FactWhere> where{};
  std::optional<double> margin{};
};

// One overload for each pair of types that the facts and their keys have.
struct Matcher {
  Relation relation;
  double tolerance;
  Places places;

  template <class T>
  requires(std::is_arithmetic_v<T>) Match operator()(const T& wanted, const T& got) const {
    return {.met = is_met(wanted, got), .margin = to_limit(wanted, got)};
  }
  Match operator()(double limit_mm, const NamedDeviation& got) const {
    return {.met = is_met(limit_mm, got.mm), .margin = to_limit(limit_mm, got.mm)};
  }
  Match operator()(const std::string& wanted, const std::string& got) const { return {.met = wanted == got}; }
  template <class T>
  Match operator()(const std::vector<T>& wanted, const std::vector<T>& got) const {
    return {.met = wanted == got};
  }
  // The limit of all axes.
  Match operator()(std::int64_t limit, const OfAxes<std::int64_t>& got) const {
    const auto largest = std::ranges::max_element(got.values);
    const auto axis = static_cast<std::size_t>(largest - got.values.begin());
    return {.met = is_met(limit, *largest),
            .got = show(*largest),
            .where = axis < places.size() ? at_place(places[axis]) : FactWhere{},
            .margin = to_limit(limit, *largest)};
  }
  template <class T>
  Match operator()(const OfAxes<T>& wanted, const OfAxes<T>& got) const {
    if (wanted.values.size() != got.values.size()) return {};
    FactWhere where = axes_off(
        std::span{wanted.values}, std::span{got.values}, [&](const T& a, const T& b) { return off(a, b); }, places);
    const bool met = where.axes.empty();
    return {.met = met, .where = std::move(where), .margin = to_tolerance(wanted, got)};
  }
  Match operator()(const Point& wanted, const Point& got) const {
    const double off_mm = (got.mm - wanted.mm).norm();
    return {.met = off_mm <= tolerance,
            .got_also = fmt::format(", {} mm away", show_small(off_mm)),
            .margin = tolerance - off_mm};
  }
  Match operator()(const Orientation& wanted, const Orientation& got) const {
    const Eigen::Matrix3d between = wanted.rotation.transpose() * got.rotation;
    const double off_deg = Eigen::AngleAxisd{between}.angle() * kDegPerRad;
    return {.met = off_deg <= tolerance,
            .got_also = fmt::format(", {} deg away", show_small(off_deg)),
            .margin = tolerance - off_deg};
  }
  Match operator()(const SerialText& wanted, SerialText got) const {
    got.as_hex = wanted.as_hex;
    return {.met = got.errors == 0 && got.bytes == wanted.bytes, .got = value_text(got)};
  }
  // Each within a tick of its time, and within its tolerance of its place.
  Match operator()(const std::vector<OutputChange>& wanted, const std::vector<OutputChange>& got) const {
    return {.met = std::ranges::equal(wanted, got, [](const OutputChange& a, const OutputChange& b) {
              const bool there = !a.tool_mm || (b.tool_mm && (*a.tool_mm - *b.tool_mm).norm() <= a.tolerance_mm);
              return a.pin == b.pin && a.level == b.level && std::abs((a.at - b.at).value()) <= kTickCycles && there;
            })};
  }
  // Nothing was measured.
  template <class Wanted, class Got>
  Match operator()(const Wanted&, const Got&) const {
    return {};
  }

 private:
  template <class T>
  [[nodiscard]] bool is_met(T wanted, T got) const {
    switch (relation) {
      case Relation::kAtMost:
        return got <= wanted;
      case Relation::kAtLeast:
        return got >= wanted;
      case Relation::kEqual:
      case Relation::kWithin:
        break;
    }
    return wanted == got;
  }

  // The margin of a limit.
  template <class T>
  [[nodiscard]] std::optional<double> to_limit(T limit, T got) const {
    if (relation == Relation::kAtMost) return static_cast<double>(limit - got);
    if (relation == Relation::kAtLeast) return static_cast<double>(got - limit);
    return std::nullopt;
  }

  // The margin of a tolerance: that of the axis with the largest difference.
  template <class T>
  [[nodiscard]] std::optional<double> to_tolerance(const OfAxes<T>& wanted, const OfAxes<T>& got) const {
    if constexpr (std::is_same_v<T, double>) {
      if (relation != Relation::kWithin) return std::nullopt;
      double largest_off = 0;
      for (std::size_t i = 0; i < wanted.values.size(); ++i) {
        largest_off = std::max(largest_off, std::fabs(got.values[i] - wanted.values[i]));
      }
      return tolerance - largest_off;
    } else {
      return std::nullopt;
    }
  }

  // 0 if the axis meets the expectation, else the size of the difference.
  template <class T>
  [[nodiscard]] double off(const T& wanted, const T& got) const {
    if constexpr (std::is_same_v<T, double>) {
      const double size = std::fabs(got - wanted);
      if (std::isnan(size)) return std::numeric_limits<double>::infinity();
      return relation == Relation::kWithin && size <= tolerance ? 0.0 : size;
    } else if constexpr (std::is_integral_v<T>) {
      return std::fabs(static_cast<double>(got - wanted));
    } else {
      return wanted == got ? 0.0 : 1.0;
    }
  }
};

// A limit keeps all of its digits.
std::string limit_text(const FactValue& limit, std::string_view unit) {
  const auto* number = std::get_if<double>(&limit);
  if (number == nullptr) return value_text(limit);
  return with_unit(number_text(*number), unit);
}

std::string expected_text(const Fact& fact, Relation relation, const FactValue& wanted) {
  switch (relation) {
    case Relation::kAtMost:
      return "at most " + limit_text(wanted, fact.unit);
    case Relation::kAtLeast:
      return "at least " + limit_text(wanted, fact.unit);
    case Relation::kEqual:
    case Relation::kWithin:
      break;
  }
  return value_text(wanted, fact.unit);
}

}  // namespace

ComparedFact compare(const Fact& fact, const Expectation& expectation, const FactValue& wanted, double tolerance,
                     const RunFacts& facts) {
  ComparedFact result;
  result.expected = expected_text(fact, expectation.relation, wanted);
  if (fact.nothing_to_judge != nullptr) {
    result.got = fact.nothing_to_judge(facts);
    if (!result.got.empty()) return result;
  }
  const FactValue value = fact.value(facts);
  const auto axis_places = fact.axis_places == nullptr ? PerAxis<std::optional<RunPlace>>{} : fact.axis_places(facts);
  const Matcher matcher{expectation.relation, tolerance, Places{axis_places}.first(facts.axis_count)};
  const Match match = std::visit(matcher, wanted, value);
  result.met = match.met;
  result.margin = match.margin;
  result.got = !match.got.empty()         ? match.got
               : fact.in_words != nullptr ? fact.in_words(facts)
                                          : value_text(value, fact.unit);
  result.got += match.got_also;
  if (result.met) return result;
  if (match.where) {
    result.where = *match.where;
  } else if (fact.where != nullptr) {
    result.where = fact.where(facts);
  }
  return result;
}

}  // namespace armature::cosim
