#include "cosim/plot/panel.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cosim/plot/simplify.hpp"

namespace armature::cosim {
namespace {

constexpr Pen kGrid{.color = "#e6e8eb", .width = 1};
constexpr Pen kZero{.color = "#b4bac2", .width = 1};
constexpr Pen kFrame{.color = "#8c959f", .width = 1};
constexpr std::string_view kNumberColor = "#57606a";
constexpr double kInvisiblePx = 0.04;  // a curve is drawn as closely as this

bool is_zero(double mark, const AxisScale& scale) {
  return std::fabs(mark) < scale.step / 2;
}

}  // namespace

Panel::Panel(SvgPicture& picture, const PanelLayout& layout) : picture_{picture}, layout_{layout} {
  const double right = layout.corner.x + layout.width;
  const double bottom = layout.corner.y + layout.height;
  const bool numbers = !layout.x_label.empty();
  for (const double mark : layout.x.marks()) {
    const double x = pixels({mark, 0}).x;
    picture.line({x, layout.corner.y}, {x, bottom}, kGrid);
    if (numbers)
      picture.text({x, bottom + 16}, layout.x.text(mark), {.size = 11, .color = kNumberColor, .anchor = "middle"});
  }
  for (const double mark : layout.y.marks()) {
    const double y = pixels({0, mark}).y;
    picture.line({layout.corner.x, y}, {right, y}, is_zero(mark, layout.y) ? kZero : kGrid);
    picture.text({layout.corner.x - 7, y + 4}, layout.y.text(mark),
                 {.size = 11, .color = kNumberColor, .anchor = "end"});
  }
  picture.frame(layout.corner, layout.width, layout.height, kFrame);
  const double middle = layout.corner.y + layout.height / 2;
  if (numbers) picture.text({layout.corner.x + layout.width / 2, bottom + 36}, layout.x_label, {.anchor = "middle"});
  picture.text({layout.corner.x - 48, middle}, layout.y_label, {.anchor = "middle", .upwards = true});
}

PlotPoint Panel::pixels(PlotPoint point) const {
  const PanelLayout& at = layout_;
  return {at.corner.x + (point.x - at.x.low) / (at.x.high - at.x.low) * at.width,
          at.corner.y + (at.y.high - point.y) / (at.y.high - at.y.low) * at.height};
}

void Panel::curve(const std::vector<PlotPoint>& points, const Pen& pen) {
  std::vector<PlotPoint> drawn;
  std::ranges::transform(points, std::back_inserter(drawn), [this](PlotPoint point) { return pixels(point); });
  picture_.polyline(simplify(drawn, kInvisiblePx), pen);
}

void Panel::dot(PlotPoint point, double radius, std::string_view color) {
  picture_.dot(pixels(point), radius, color);
}

}  // namespace armature::cosim
