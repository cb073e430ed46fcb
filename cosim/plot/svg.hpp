// Writes a picture as SVG text. Coordinates have two digits after the point, so that equal pictures are equal bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

struct PlotPoint {
  double x = 0, y = 0;
};

// How a line is drawn.
struct Pen {
  std::string_view color;
  double width = 1;
  std::string_view dashes{};  // stroke-dasharray; empty: a solid line
};

struct TextStyle {
  double size = 12;
  std::string_view color = "#1f2328";
  std::string_view anchor = "start";  // start | middle | end
  bool bold = false;
  bool upwards = false;  // rotated by 90 degrees
};

// Pixels, from the upper left corner.
class SvgPicture {
 public:
  SvgPicture(double width, double height, std::string_view title);

  void line(PlotPoint from, PlotPoint to, const Pen& pen);
  void polyline(const std::vector<PlotPoint>& points, const Pen& pen);
  void frame(PlotPoint corner, double width, double height, const Pen& pen);
  void dot(PlotPoint center, double radius, std::string_view color);
  void text(PlotPoint at, std::string_view text, const TextStyle& style);

  // The whole document.
  [[nodiscard]] std::string document() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace armature::cosim
