// The scale of one axis of a diagram: round numbers at its marks.
#pragma once

#include <string>
#include <vector>

namespace armature::cosim {

struct AxisScale {
  double low = 0, high = 1;  // of the diagram
  double step = 0.2;         // between marks: 1, 2 or 5 times a power of ten
  int digits = 1;            // after the point, of the text of a mark

  // The multiples of `step` from `low` to `high`.
  [[nodiscard]] std::vector<double> marks() const;
  [[nodiscard]] std::string text(double mark) const;
};

// A scale that begins and ends at the range itself, with at most `most_marks` steps.
[[nodiscard]] AxisScale exact_scale(double low, double high, int most_marks);

// The same, but the range is extended to whole steps.
[[nodiscard]] AxisScale round_scale(double low, double high, int most_marks);

}  // namespace armature::cosim
