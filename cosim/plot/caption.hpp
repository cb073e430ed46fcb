// What stands above the diagrams of a picture.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cosim/plot/svg.hpp"

namespace armature::cosim {

inline constexpr double kPictureWidth = 760;
inline constexpr double kPictureLeft = 72;    // of the frames: room for the numbers
inline constexpr double kPictureRight = 736;  // of the frames
inline constexpr double kRowGap = 18;         // between lines of text

struct LegendEntry {
  std::string text;
  Pen pen;
  double width = 0;  // of the entry in the row
};

// The text in lines of at most `most` characters, broken at blanks. A longer word has a line of its own.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t most);

// A title, broken into lines, and a line below it. `height` counts from the top of the picture.
class Caption {
 public:
  Caption(std::string_view title, std::string_view subtitle);
  [[nodiscard]] double height() const;
  void draw(SvgPicture& picture) const;

 private:
  std::vector<std::string> title_;
  std::string subtitle_;
};

// A row of short lines, each with its text.
void draw_legend(SvgPicture& picture, double y, const std::vector<LegendEntry>& entries);

}  // namespace armature::cosim
