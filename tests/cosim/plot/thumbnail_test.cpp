#include "cosim/plot/thumbnail.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <regex>
#include <string>
#include <vector>

namespace armature::cosim {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

// Two links of 100 mm in a level plane. Joint 1 turns by a degree in each row, from 0 to 90; a row is 10 ticks.
RunRecord quarter_turn(Json moves) {
  RunRecord run;
  run.trace.columns = {
      {.name = "tick"}, {.name = "time_s", .digits = 3}, {.name = "j1_enc_deg"}, {.name = "j2_enc_deg"}};
  for (std::int64_t row = 0; row <= 90; ++row) {
    for (std::size_t i = 0; const std::int64_t value : {10 * row, row, row, std::int64_t{0}}) {
      run.trace.columns[i++].values.push_back(value);
    }
  }
  const Json link = {{"alpha_deg", 0}, {"a_mm", 100}, {"d_mm", 0}, {"sign", 1}, {"offset_deg", 0}};
  run.summary = {
      {"arm", {{"links", Json::array({link, link})}, {"tool", {{"xyz_mm", {0, 0, 0}}, {"rpy_deg", {0, 0, 0}}}}}},
      {"result", {{"final_joint_deg", {0, 0}}, {"moves", std::move(moves)}}}};
  return run;
}

Json path_between(int start, int ticks) {
  return {{"start_tick", start}, {"duration_ticks", ticks}, {"taken_ticks", ticks}, {"path", Json::object()}};
}

struct Extent {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};

Extent extent_of(const std::string& picture) {
  Extent extent;
  const std::regex pair{R"(([-\d.]+),([-\d.]+))"};
  for (auto at = std::sregex_iterator{picture.begin(), picture.end(), pair}; at != std::sregex_iterator{}; ++at) {
    const double x = std::stod((*at)[1]), y = std::stod((*at)[2]);
    extent = {std::min(extent.left, x), std::max(extent.right, x), std::min(extent.top, y), std::max(extent.bottom, y)};
  }
  return extent;
}

TEST(Thumbnail, OfAPathHasTheSameScaleInBothDirections) {
  const std::string picture = thumbnail(quarter_turn(Json::array({path_between(0, 900)})));
  EXPECT_THAT(picture, HasSubstr("<title>path of the tool</title>"));
  const Extent extent = extent_of(picture);
  EXPECT_NEAR(extent.right - extent.left, 70, 0.1);  // a quarter of a circle
  EXPECT_NEAR(extent.bottom - extent.top, 70, 0.1);
  EXPECT_NEAR((extent.left + extent.right) / 2, 75, 0.1);
}

TEST(Thumbnail, OfJointMovesHasACurveForEachJoint) {
  const std::string picture = thumbnail(quarter_turn(Json::array()));
  EXPECT_THAT(picture, HasSubstr("<title>angles of the joints</title>"));
  const Extent extent = extent_of(picture);
  EXPECT_NEAR(extent.right - extent.left, 136, 0.1);
  EXPECT_NEAR(extent.bottom - extent.top, 70, 0.1);
}

TEST(Thumbnail, APathWithoutARowShowsJoints) {
  EXPECT_THAT(thumbnail(quarter_turn(Json::array({path_between(2000, 10)}))), HasSubstr("angles of the joints"));
}

}  // namespace
}  // namespace armature::cosim
