#include "cosim/plot/drawing_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armature::cosim {
namespace {

using Eigen::Vector3d;

TEST(DrawingPlane, ALevelPlaneIsSeenFromAbove) {
  const DrawingPlane plane = drawing_plane({{400, -10, 5}, {400, 30, 5}, {420, 30, 5}, {420, -10, 5}});
  EXPECT_EQ(plane.right.label, "x [mm]");
  EXPECT_EQ(plane.up.label, "y [mm]");
  EXPECT_NEAR(plane.tilt_deg, 0, 1e-9);
  EXPECT_NEAR(plane.of({420, -10, 5}).x, 420, 1e-9);
  EXPECT_NEAR(plane.of({420, -10, 5}).y, -10, 1e-9);
}

TEST(DrawingPlane, AWallIsSeenFromTheFrontWithZUpwards) {
  const DrawingPlane plane = drawing_plane({{500, 0, 100}, {500, 50, 100}, {500, 50, 180}});
  EXPECT_EQ(plane.right.label, "y [mm]");
  EXPECT_EQ(plane.up.label, "z [mm]");
  EXPECT_NEAR(plane.tilt_deg, 90, 1e-9);
}

TEST(DrawingPlane, KeepsDistancesOnATiltedTable) {
  const double half = std::sqrt(0.5);
  const Vector3d up{half, 0, half};
  const Vector3d center{470, 0, 400};
  const Vector3d a = center + 10 * up;
  const Vector3d b = center + Vector3d{0, 7, 0};
  const Vector3d c = center - 4 * up - Vector3d{0, 3, 0};
  const DrawingPlane plane = drawing_plane({a, b, c});
  EXPECT_NEAR(plane.tilt_deg, 45, 1e-9);
  EXPECT_EQ(plane.right.label, "\u2212y [mm]");  // the viewer stands where the arm stands
  EXPECT_EQ(plane.up.label, "up the plane [mm]");
  EXPECT_NEAR(plane.of(a).y - plane.of(c).y, 14, 1e-9);
  EXPECT_NEAR(plane.of(b).x, -7, 1e-9);
}

TEST(DrawingPlane, AStraightLineHasAPlane) {
  for (const Vector3d& end : {Vector3d{300, 0, 0}, Vector3d{0, 0, 300}, Vector3d{0, 0, 0}}) {
    const DrawingPlane plane = drawing_plane({{0, 0, 0}, end});
    EXPECT_NEAR(plane.right.along.dot(plane.up.along), 0, 1e-12);
    const PlotPoint at = plane.of(end);
    const PlotPoint from = plane.of({0, 0, 0});
    EXPECT_NEAR(std::hypot(at.x - from.x, at.y - from.y), end.norm(), 1e-9);
  }
}

TEST(DrawingPlane, OfAFrameHasItsCoordinates) {
  // Upside down: x is that of the base, y and z are opposite.
  RecordedFrame frame{.name = "plate"};
  frame.base_T_frame.rotation = Vector3d{1, -1, -1}.asDiagonal();
  frame.base_T_frame.position_mm = {400, 50, 200};
  const DrawingPlane plane = plane_of_frame(frame);
  EXPECT_EQ(plane.right.label, "x in plate [mm]");
  EXPECT_EQ(plane.frame, "the frame plate");
  const PlotPoint at = plane.of({407, 47, 190});
  EXPECT_NEAR(at.x, 7, 1e-9);
  EXPECT_NEAR(at.y, 3, 1e-9);
  EXPECT_EQ(plane_of_frame({.name = "base"}).up.label, "y [mm]");
}

TEST(DrawingPlane, AFrameShowsWhatIsAboutLevelInIt) {
  RecordedFrame wall{.name = "wall"};
  wall.base_T_frame.rotation << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // its z is x of the base
  const SpacePoints drawn{{500, 0, 0}, {500, 40, 0}, {505, 40, 30}};
  EXPECT_TRUE(is_level_in(wall, drawn));
  EXPECT_FALSE(is_level_in({.name = "base"}, drawn));
}

}  // namespace
}  // namespace armature::cosim
