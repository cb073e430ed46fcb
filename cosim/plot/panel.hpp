// One diagram of a picture: frame, grid, marks with numbers, curves.
#pragma once

#include <string_view>
#include <vector>

#include "cosim/plot/axis_scale.hpp"
#include "cosim/plot/svg.hpp"

namespace armature::cosim {

struct PanelLayout {
  PlotPoint corner{};  // upper left one of the frame
  double width = 0, height = 0;
  AxisScale x, y;
  std::string_view x_label{}, y_label{};  // with the unit; an empty `x_label` also hides the numbers
};

class Panel {
 public:
  // Draws everything but the curves.
  Panel(SvgPicture& picture, const PanelLayout& layout);

  // `points` in the units of the scales.
  void curve(const std::vector<PlotPoint>& points, const Pen& pen);
  void dot(PlotPoint point, double radius, std::string_view color);

 private:
  [[nodiscard]] PlotPoint pixels(PlotPoint point) const;

  SvgPicture& picture_;
  PanelLayout layout_;
};

}  // namespace armature::cosim
