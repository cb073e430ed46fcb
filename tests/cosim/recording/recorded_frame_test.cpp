#include "cosim/recording/recorded_frame.hpp"

#include <gtest/gtest.h>

namespace armature::cosim {
namespace {

using Json = nlohmann::ordered_json;

const Json kFrames = {{{"name", "plate"}, {"xyz_mm", {1, 2, 3}}, {"rpy_deg", {0, 0, 0}}},
                      {{"name", "table"}, {"xyz_mm", {400, 0, 300}}, {"rpy_deg", {0, -90, 0}}}};

TEST(RecordedFrame, IsTheOneThatTheProgramNames) {
  const auto frame = recorded_program_frame({{"frames", kFrames}, {"program_frame", "table"}});
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->name, "table");
  EXPECT_EQ(frame->base_T_frame.position_mm, Eigen::Vector3d(400, 0, 300));
  // About y by -90 degrees, x of the frame points to z.
  EXPECT_LT((frame->base_T_frame.rotation.col(0) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(RecordedFrame, OfTheBaseIsWhereTheBaseIs) {
  const auto frame = recorded_program_frame({{"frames", kFrames}, {"program_frame", "base"}});
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->base_T_frame.rotation.isIdentity(0));
}

TEST(RecordedFrame, IsNoneWithoutAProgramAndInAnOldSummary) {
  EXPECT_FALSE(recorded_program_frame({{"program_frame", nullptr}}));
  EXPECT_FALSE(recorded_program_frame(Json::object()));
}

}  // namespace
}  // namespace armature::cosim
