#include "cosim/mesh/stl_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

using Corner = std::array<float, 3>;
using Triangle = std::array<Corner, 3>;

std::string text_of(const std::vector<Triangle>& triangles) {
  std::string text = "solid a part\n";
  for (const Triangle& triangle : triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const auto& [x, y, z] : triangle) text += fmt::format("   vertex {} {} {}\n", x, y, z);
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid a part\n";
}

void add_word(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i) & 0xff);
}

std::string binary_of(const std::vector<Triangle>& triangles) {
  std::string bytes = "solid is how some binary headers begin";
  bytes.resize(80);
  add_word(bytes, static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles) {
    bytes.append(12, '\xff');  // a normal that is no number
    for (const Corner& corner : triangle) {
      for (const float value : corner) add_word(bytes, std::bit_cast<std::uint32_t>(value));
    }
    bytes.append(2, '\x7f');
  }
  return bytes;
}

std::string refusal(const std::string& content) {
  try {
    static_cast<void>(parse_stl(content, "part.stl"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const Triangle kTriangle{{{0, 0, 0}, {10, 0, 0}, {0, 20.5, 0}}};
const Triangle kNeighbour{{{10, 0, 0}, {0, 20.5, 0}, {10, 20.5, -3}}};

TEST(StlFile, GivesTheSameTrianglesAsTextAndAsBinaryData) {
  constexpr std::uint32_t kSeed = 36;
  SCOPED_TRACE(fmt::format("seed {}", kSeed));
  std::mt19937 random{kSeed};
  std::uniform_real_distribution<float> places{-900, 900};
  std::vector<Triangle> triangles(500);
  for (Triangle& triangle : triangles) {
    for (Corner& corner : triangle) {
      for (float& value : corner) value = places(random);
    }
  }
  const TriangleMesh text = parse_stl(text_of(triangles), "text.stl");
  const TriangleMesh binary = parse_stl(binary_of(triangles), "binary.stl");
  EXPECT_EQ(text.corners, binary.corners);
  EXPECT_EQ(text.triangles, binary.triangles);
  ASSERT_EQ(text.triangles.size(), triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double mm = text.corners[text.triangles[i][corner]][axis] / 100.0;
        EXPECT_NEAR(mm, triangles[i][corner][axis], 0.005 + 1e-9);
      }
    }
  }
}

TEST(StlFile, HasEachPlaceOnce) {
  const TriangleMesh mesh = parse_stl(text_of({kTriangle, kNeighbour}), "part.stl");
  const std::vector<std::array<std::int32_t, 3>> corners{{0, 0, 0}, {1000, 0, 0}, {0, 2050, 0}, {1000, 2050, -300}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {1, 2, 3}};
  EXPECT_EQ(mesh.corners, corners);
  EXPECT_EQ(mesh.triangles, triangles);
}

TEST(StlFile, LeavesOutTrianglesThatRoundingMakesALine) {
  const Triangle thin{{{5, 5, 5}, {5.001F, 5, 5}, {5, 9, 5}}};
  EXPECT_EQ(parse_stl(text_of({thin, kTriangle}), "part.stl").triangles.size(), 1u);
  EXPECT_EQ(refusal(text_of({thin})), "part.stl: has no triangle");
}

TEST(StlFile, ReadsWhatOtherProgramsWrite) {
  const std::string odd =
      "  SOLID\r\nfacet normal nan nan nan\r\nouter loop vertex 0 0 +0 VERTEX 1.0e+01 0 0\r\n\r\n"
      "vertex\r\n0 2.05E1 -0\r\nendloop endfacet\r\nendsolid\r\nsolid second part\r\nendsolid second part";
  const TriangleMesh mesh = parse_stl(odd, "part.stl");
  EXPECT_EQ(mesh.corners, parse_stl(text_of({kTriangle}), "part.stl").corners);
}

TEST(StlFile, NamesTheLineOfAMistakeInAText) {
  const std::string good = text_of({kTriangle});
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string text = good;
    return refusal(text.replace(text.find(what), what.size(), instead));
  };
  EXPECT_EQ(with("solid", "v 1 2 3"),
            "part.stl: is no STL file: it is neither binary nor does it begin with \"solid\"");
  EXPECT_EQ(with("10 0 0", "10 0"), "part.stl:6: expected a number from -100000 to 100000 (mm), found \"vertex\"");
  EXPECT_EQ(with("10 0 0", "10 0x 0"), "part.stl:5: expected a number from -100000 to 100000 (mm), found \"0x\"");
  EXPECT_EQ(with("10 0 0", "1e6 0 0"), "part.stl:5: expected a number from -100000 to 100000 (mm), found \"1e6\"");
  EXPECT_EQ(with("10 0 0", "inf 0 0"), "part.stl:5: expected a number from -100000 to 100000 (mm), found \"inf\"");
  EXPECT_EQ(with("   vertex 0 20.5 0\n", ""), "part.stl:6: expected \"vertex\", found \"endloop\"");
  EXPECT_EQ(with("outer", "inner"), "part.stl:3: expected \"outer\", found \"inner\"");
  EXPECT_EQ(with("endsolid a part\n", ""), "part.stl:8: expected \"facet\" or \"endsolid\", found the end of the file");
  EXPECT_EQ(refusal(good + "garbage"), "part.stl:10: expected \"solid\", found \"garbage\"");
  EXPECT_EQ(refusal(""), "part.stl: is no STL file: it is neither binary nor does it begin with \"solid\"");
}

TEST(StlFile, NamesTheTriangleOfAMistakeInBinaryData) {
  Triangle wrong = kNeighbour;
  wrong[2][1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal(binary_of({kTriangle, wrong})),
            "part.stl: triangle 2: expected a number from -100000 to 100000 (mm), found nan");
  wrong[2][1] = 2e5F;
  EXPECT_EQ(refusal(binary_of({wrong})),
            "part.stl: triangle 1: expected a number from -100000 to 100000 (mm), found 200000");
  EXPECT_EQ(refusal(binary_of({})), "part.stl: has no triangle");
}

TEST(StlFile, RefusesBinaryDataOfAnotherSize) {
  std::string bytes = binary_of({kTriangle, kNeighbour});
  bytes.pop_back();
  EXPECT_EQ(refusal(bytes),
            "part.stl: is no binary STL file, or not all of it: it has 183 bytes, and 2 triangles need 184");
  EXPECT_EQ(refusal(std::string(70, '\0')), "part.stl: is no STL file: it is too short for a binary one");
}

TEST(StlFile, RefusesMoreTrianglesThanAPageCanShow) {
  std::vector<Triangle> triangles(kMaxMeshTriangles, kTriangle);
  EXPECT_EQ(parse_stl(binary_of(triangles), "part.stl").triangles.size(), kMaxMeshTriangles);
  triangles.push_back(kTriangle);
  EXPECT_EQ(refusal(binary_of(triangles)), "part.stl: more than 200000 triangles");
  const std::string one = text_of({kTriangle});
  const std::size_t begin = one.find(" facet"), end = one.find("endsolid");
  std::string text = one.substr(0, begin);
  for (std::size_t i = 0; i <= kMaxMeshTriangles; ++i) text.append(one, begin, end - begin);
  EXPECT_EQ(refusal(text), "part.stl:1400002: more than 200000 triangles");
}

}  // namespace
}  // namespace armature::cosim
