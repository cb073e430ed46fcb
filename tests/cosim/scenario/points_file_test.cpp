#include "cosim/scenario/files/points_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

class PointsFile : public testing::Test {
 protected:
  PointsFile() {
    scenario_.file = (folder_.path() / "scenario.toml").string();
    scenario_.moves.push_back({.kind = PolylineSpec{.points_file = "points.csv"}, .line = 7, .index = 2});
  }

  void write(const std::string& text) const { folder_.write("points.csv", text); }
  [[nodiscard]] std::string problems() {
    std::vector<Problem> all;
    load_points(scenario_, all);
    std::string text;
    for (const Problem& problem : all) text += fs::path{problem.text()}.lexically_normal().filename().string() + "\n";
    return text;
  }
  [[nodiscard]] const std::vector<std::array<double, 3>>& points() const {
    return std::get<PolylineSpec>(scenario_.moves[0].kind).points_mm;
  }

  test::TempFolder folder_;
  Scenario scenario_;
};

TEST_F(PointsFile, HasPointsOfWhichNoneIsEqualToTheOneBefore) {
  write("x_mm,y_mm,z_mm\n1,2,3\n1,2,3\n4,5.5,-6\n1,2,3\n");
  EXPECT_EQ(problems(), "");
  const std::vector<std::array<double, 3>> expected{{1, 2, 3}, {4, 5.5, -6}, {1, 2, 3}};
  EXPECT_EQ(points(), expected);
  ASSERT_EQ(scenario_.sources.size(), 1u);
  EXPECT_EQ(scenario_.sources[0].sha256.size(), 64u);
}

TEST_F(PointsFile, NamesAFileThatIsMissing) {
  EXPECT_EQ(problems(), "points.csv\n");  // the message ends with its name
}

TEST_F(PointsFile, RefusesAWrongHeaderNoPointAndATooLargeNumber) {
  write("x,y,z\n1,2,3\n");
  EXPECT_NE(problems(), "");
  write("x_mm,y_mm,z_mm\n");
  EXPECT_EQ(problems(), "points.csv: expected at least one point\n");
  write("x_mm,y_mm,z_mm\n1,2,3\n1,1e9,3\n");
  EXPECT_NE(problems().find(":3:3"), std::string::npos);
  EXPECT_TRUE(scenario_.sources.empty());
}

TEST_F(PointsFile, RefusesTooManyPoints) {
  std::string text = "x_mm,y_mm,z_mm\n";
  for (std::size_t i = 0; i < kMaxPoints + 5; ++i) text += std::to_string(i % 1000) + ",0,0\n";
  write(text);
  EXPECT_NE(problems().find("more than 100000 points"), std::string::npos);
}

}  // namespace
}  // namespace armature::cosim
