#include "cosim/plot/caption.hpp"

#include <algorithm>

#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr double kCaptionTop = 30;
constexpr std::size_t kTitleCharacters = 76;

// Characters of a UTF-8 text: the bytes that do not continue one.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t most) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (word.empty()) continue;
    if (!lines.empty() && characters(lines.back()) + 1 + characters(word) <= most) {
      lines.back().append(" ").append(word);
    } else {
      lines.emplace_back(word);
    }
  }
  return lines;
}

Caption::Caption(std::string_view title, std::string_view subtitle)
    : title_{wrapped(printable(title), kTitleCharacters)}, subtitle_{subtitle} {}

double Caption::height() const {
  return kCaptionTop + kRowGap * static_cast<double>(title_.size());
}

void Caption::draw(SvgPicture& picture) const {
  double y = kCaptionTop;
  for (const std::string& line : title_) {
    picture.text({24, y}, line, {.size = 14, .bold = true});
    y += kRowGap;
  }
  picture.text({24, y}, subtitle_, {.size = 12, .color = "#57606a"});
}

void draw_legend(SvgPicture& picture, double y, const std::vector<LegendEntry>& entries) {
  constexpr double kSwatch = 20;
  double x = kPictureLeft;
  for (const LegendEntry& entry : entries) {
    picture.line({x, y - 4}, {x + kSwatch, y - 4}, entry.pen);
    picture.text({x + kSwatch + 5, y}, entry.text, {.size = 11});
    x += entry.width;
  }
}

}  // namespace armature::cosim
