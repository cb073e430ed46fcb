#include "cosim/plot/svg.hpp"

#include <fmt/format.h>

#include <iterator>

#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/xml_text.hpp"

namespace armature::cosim {
namespace {

// Two digits, without zeros at the end and without a minus before zero.
std::string px(double value) {
  std::string text = fixed_text(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string stroke(const Pen& pen) {
  std::string text = fmt::format(R"(stroke="{}" stroke-width="{}")", pen.color, px(pen.width));
  if (!pen.dashes.empty()) text += fmt::format(R"( stroke-dasharray="{}")", pen.dashes);
  return text;
}

}  // namespace

SvgPicture::SvgPicture(double width, double height, std::string_view title) {
  body_ = fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" )"
                      R"(font-family="'DejaVu Sans', Verdana, sans-serif">)"
                      "\n<title>{2}</title>\n"
                      R"(<rect width="{0}" height="{1}" rx="6" fill="#ffffff"/>)"
                      "\n",
                      px(width), px(height), xml_text(printable(title)));
}

void SvgPicture::line(PlotPoint from, PlotPoint to, const Pen& pen) {
  fmt::format_to(std::back_inserter(body_),
                 R"(<line x1="{}" y1="{}" x2="{}" y2="{}" {}/>)"
                 "\n",
                 px(from.x), px(from.y), px(to.x), px(to.y), stroke(pen));
}

void SvgPicture::polyline(const std::vector<PlotPoint>& points, const Pen& pen) {
  fmt::format_to(std::back_inserter(body_), R"(<polyline fill="none" stroke-linejoin="round" {} points=")",
                 stroke(pen));
  for (std::size_t i = 0; i < points.size(); ++i) {
    fmt::format_to(std::back_inserter(body_), "{}{},{}", i == 0 ? "" : " ", px(points[i].x), px(points[i].y));
  }
  body_ += "\"/>\n";
}

void SvgPicture::frame(PlotPoint corner, double width, double height, const Pen& pen) {
  fmt::format_to(std::back_inserter(body_),
                 R"(<rect x="{}" y="{}" width="{}" height="{}" fill="none" {}/>)"
                 "\n",
                 px(corner.x), px(corner.y), px(width), px(height), stroke(pen));
}

void SvgPicture::dot(PlotPoint center, double radius, std::string_view color) {
  fmt::format_to(std::back_inserter(body_),
                 R"(<circle cx="{}" cy="{}" r="{}" fill="{}"/>)"
                 "\n",
                 px(center.x), px(center.y), px(radius), color);
}

void SvgPicture::text(PlotPoint at, std::string_view text, const TextStyle& style) {
  fmt::format_to(std::back_inserter(body_), R"(<text x="{0}" y="{1}" font-size="{2}" fill="{3}")", px(at.x), px(at.y),
                 px(style.size), style.color);
  if (style.anchor != "start") fmt::format_to(std::back_inserter(body_), R"( text-anchor="{}")", style.anchor);
  if (style.bold) body_ += R"( font-weight="bold")";
  if (style.upwards) {
    fmt::format_to(std::back_inserter(body_), R"~( transform="rotate(-90 {} {})")~", px(at.x), px(at.y));
  }
  body_.append(">").append(xml_text(printable(text))).append("</text>\n");
}

}  // namespace armature::cosim
