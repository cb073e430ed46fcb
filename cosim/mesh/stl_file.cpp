#include "cosim/mesh/stl_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "cosim/mesh/mesh_builder.hpp"
#include "cosim/text/csv_line.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kPreambleBytes = kHeaderBytes + 4;  // with the number of triangles
constexpr std::size_t kNormalBytes = 12;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kFloatBytes = 4;

using Corners = std::array<MeshBuilder::Point, 3>;

std::string too_many() {
  return "more than " + std::to_string(kMaxMeshTriangles) + " triangles";
}

bool is_place(double value) {
  return std::isfinite(value) && std::abs(value) <= kMaxMeshMm;
}

std::string expected_place(const std::string& found) {
  return "expected a number from -" + number_text(kMaxMeshMm) + " to " + number_text(kMaxMeshMm) + " (mm), found " +
         found;
}

std::size_t binary_size(std::size_t triangles) {
  return kPreambleBytes + triangles * kTriangleBytes;
}

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
  }
  return value;
}

// The size tells: text of exactly this size is as good as impossible, and a binary header may begin with "solid".
bool is_binary(std::string_view bytes) {
  return bytes.size() >= kPreambleBytes && bytes.size() == binary_size(word_at(bytes, kHeaderBytes));
}

[[noreturn]] void refuse_binary(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kPreambleBytes) throw InputError{name, "is no STL file: it is too short for a binary one"};
  const std::size_t count = word_at(bytes, kHeaderBytes);
  throw InputError{name, "is no binary STL file, or not all of it: it has " + std::to_string(bytes.size()) +
                             " bytes, and " + std::to_string(count) + " triangles need " +
                             std::to_string(binary_size(count))};
}

// The coordinates of a corner, which begin at `at`. `triangle`: its number, from 1.
MeshBuilder::Point corner_at(std::string_view bytes, std::size_t at, std::size_t triangle, const std::string& name) {
  MeshBuilder::Point corner{};
  for (double& value : corner) {
    value = std::bit_cast<float>(word_at(bytes, at));
    at += kFloatBytes;
    if (is_place(value)) continue;
    throw InputError{name, "triangle " + std::to_string(triangle) + ": " + expected_place(number_text(value))};
  }
  return corner;
}

TriangleMesh parse_binary(std::string_view bytes, const std::string& name) {
  const std::size_t count = word_at(bytes, kHeaderBytes);
  if (count > kMaxMeshTriangles) throw InputError{name, too_many()};
  MeshBuilder mesh;
  for (std::size_t i = 0; i < count; ++i) {
    Corners corners{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t at = binary_size(i) + kNormalBytes + k * corners.at(k).size() * kFloatBytes;
      corners.at(k) = corner_at(bytes, at, i + 1, name);
    }
    mesh.add(corners);
  }
  return mesh.take();
}

// The words of a text with their lines.
class StlText {
 public:
  StlText(std::string_view text, const std::string& name) : rest_{text}, name_{name} {}

  // Empty at the end of the text.
  [[nodiscard]] std::string_view peek() {
    while (line_rest_.empty() && !rest_.empty()) {
      line_rest_ = pop_line(rest_);
      skip_blanks();
      ++line_;
    }
    return line_rest_.substr(0, line_rest_.find_first_of(kBlanks));
  }
  void drop_line() { line_rest_ = {}; }

  // False, without a change, if another word follows.
  bool take(std::string_view word) {
    const std::string_view found = peek();
    const auto same = [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); };
    if (!std::ranges::equal(word, found, same)) return false;
    pop(found);
    return true;
  }
  void require(std::string_view word) {
    if (!take(word)) refuse("expected \"" + std::string{word} + "\", found " + found());
  }
  // As a float, so that text and binary data of a part give the same corners.
  [[nodiscard]] double number() {
    const std::string_view word = peek();
    const std::optional<float> value = parsed_number<float>(word.substr(word.starts_with('+') ? 1 : 0));
    if (!value || !is_place(*value)) refuse(expected_place(found()));
    pop(word);
    return *value;
  }

  [[nodiscard]] std::string found() {
    const std::string_view word = peek();
    return word.empty() ? "the end of the file" : "\"" + printable(std::string{word}) + "\"";
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError{Problem{name_, Origin{std::max(line_, 1), 0, {}}, {}, why}};
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r";

  void skip_blanks() { line_rest_.remove_prefix(std::min(line_rest_.find_first_not_of(kBlanks), line_rest_.size())); }
  void pop(std::string_view word) {
    line_rest_.remove_prefix(word.size());
    skip_blanks();
  }

  std::string_view rest_, line_rest_;
  const std::string& name_;
  int line_ = 0;
};

// Of the normal, any words are accepted: some programs write `nan` for a triangle without an area.
Corners read_facet(StlText& text) {
  text.require("normal");
  text.drop_line();
  text.require("outer");
  text.require("loop");
  Corners corners{};
  for (MeshBuilder::Point& corner : corners) {
    text.require("vertex");
    for (double& value : corner) value = text.number();
  }
  text.require("endloop");
  text.require("endfacet");
  return corners;
}

TriangleMesh parse_text(std::string_view content, const std::string& name) {
  StlText text{content, name};
  if (!text.take("solid"))
    throw InputError{name, "is no STL file: it is neither binary nor does it begin with \"solid\""};
  text.drop_line();
  MeshBuilder mesh;
  std::size_t count = 0;
  while (true) {
    if (text.take("facet")) {
      if (++count > kMaxMeshTriangles) text.refuse(too_many());
      mesh.add(read_facet(text));
    } else if (text.take("endsolid")) {
      text.drop_line();
      if (text.peek().empty()) return mesh.take();
      text.require("solid");
      text.drop_line();
    } else {
      text.refuse("expected \"facet\" or \"endsolid\", found " + text.found());
    }
  }
}

}  // namespace

TriangleMesh parse_stl(std::string_view content, const std::string& name) {
  const bool binary = is_binary(content);
  if (!binary && content.find('\0') != std::string_view::npos) refuse_binary(content, name);
  TriangleMesh mesh = binary ? parse_binary(content, name) : parse_text(content, name);
  if (mesh.triangles.empty()) throw InputError{name, "has no triangle"};
  return mesh;
}

TriangleMesh read_stl(const std::filesystem::path& file) {
  return parse_stl(read_binary_file(file, kMaxMeshBytes), file.string());
}

}  // namespace armature::cosim
