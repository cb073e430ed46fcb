#include "controller/language/gcode/execute/coordinates.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::Axes6;
using gcode::SetG5xOffset;
using gcode::SetG92Offset;
using gcode::SetXyRotation;

// The tool does not move in any of these tests.
struct GcodeCoordinates : testing::Test, GcodeParts {
  GcodeCoordinates() {
    coordinates.begin_program(kMachine);
    sink.clear();
  }
  void expect_place(const Axes6& expected, const char* text) {
    for (std::size_t i = 0; i < gcode::kAxes; ++i) {
      EXPECT_NEAR(coordinates.place()[i], expected[i], 1e-12) << text << ", axis " << i;
      EXPECT_NEAR(coordinates.machine()[i], kMachine[i], 1e-12) << text << ", axis " << i;
    }
  }
  void set_data(const char* text) { ASSERT_FALSE(coordinates.set_data(block(text))) << text; }
  void set_tool_offset(const char* text) { ASSERT_FALSE(coordinates.set_tool_offset(block(text))) << text; }

  static constexpr Axes6 kMachine{10, 5, 3, 30, 20, 10};
};

TEST_F(GcodeCoordinates, AreTurnedAndShiftedByTheActiveSystem) {
  set_data("G10 L2 P1 X10 Z1 A5 R90");
  EXPECT_TRUE((sink.made<SetG5xOffset, SetXyRotation>()));
  expect_place({5, 0, 2, 25, 20, 10}, "X of the system points along Y of the machine");
  set_data("G10 L2 P2 Y1");
  expect_place({5, 0, 2, 25, 20, 10}, "another system");
  sink.clear();
  coordinates.set_system(block("G55"));
  EXPECT_TRUE((sink.made<SetG5xOffset, SetG92Offset, SetXyRotation>()));
  EXPECT_EQ(sink.last<SetG5xOffset>().index, 2);
  expect_place({10, 4, 3, 30, 20, 10}, "G55");
  sink.clear();
  coordinates.set_system(block("G55"));
  EXPECT_TRUE(sink.calls.empty());
}

TEST_F(GcodeCoordinates, GiveThePresentPlaceTheWordsOfG92) {
  coordinates.set_g92(block("G92 X1 A0"));
  expect_place({1, 5, 3, 0, 20, 10}, "G92");
  coordinates.set_g92(block("G92.2"));
  expect_place(kMachine, "G92.2");
  coordinates.set_g92(block("G92.3"));
  expect_place({1, 5, 3, 0, 20, 10}, "G92.3");
  coordinates.set_g92(block("G92.1"));
  coordinates.set_g92(block("G92.3"));
  expect_place(kMachine, "G92.1 has forgotten it");
  coordinates.set_g92(block("G52 X1"));
  expect_place({9, 5, 3, 30, 20, 10}, "G52");
}

TEST_F(GcodeCoordinates, GiveThePresentPlaceTheWordsOfG10L20) {
  set_data("G10 L2 P1 R30");
  coordinates.set_g92(block("G92 Y2"));
  const double y = coordinates.place()[1];
  set_data("G10 L20 P0 X-4");
  EXPECT_NEAR(coordinates.place()[0], -4.0, 1e-12);
  EXPECT_NEAR(coordinates.place()[1], y, 1e-12);
  EXPECT_EQ(code_of(coordinates.set_data(block("G10 L20 P1 X0 R3"))), gcode::ErrorCode::kWordNotUsed);
  EXPECT_EQ(code_of(coordinates.set_data(block("G10 L3 P1"))), gcode::ErrorCode::kWordRange);
}

TEST_F(GcodeCoordinates, UseTheOffsetOfATool) {
  tools.add(1, Axes6{});
  tools.add(2, {0, 0, 2, 0, 0, 0});
  set_data("G10 L1 P1 Z7");
  set_tool_offset("G43 H2");
  expect_place({10, 5, 1, 30, 20, 10}, "G43 H2");
  ASSERT_FALSE(tools.select(block("T1")));
  tools.change(block("M6"));
  set_tool_offset("G43");
  expect_place({10, 5, -4, 30, 20, 10}, "G43 is for the tool in the spindle");
  EXPECT_EQ(coordinates.value_of("_tool_offset"), 1.0);
  set_tool_offset("G43.1 X1");
  expect_place({9, 5, -4, 30, 20, 10}, "G43.1 changes only the axes of its words");
  set_tool_offset("G49");
  expect_place(kMachine, "G49");
  EXPECT_EQ(code_of(coordinates.set_tool_offset(block("G43 H3"))), gcode::ErrorCode::kToolUnknown);
}

TEST_F(GcodeCoordinates, MeasureAToolAtThePresentPlace) {
  tools.add(1, Axes6{});
  set_data("G10 L2 P1 Z1");
  set_data("G10 L10 P1 Z0");
  set_tool_offset("G43 H1");
  expect_place({10, 5, 0, 30, 20, 10}, "L10: in the active system");
  set_data("G10 L2 P9 Z-1");
  set_data("G10 L11 P1 Z0");
  coordinates.set_system(block("G59.3"));
  set_tool_offset("G43 H1");
  expect_place({10, 5, 0, 30, 20, 10}, "L11: in system 9");
}

TEST_F(GcodeCoordinates, StoreThePlaceOfTheMachine) {
  coordinates.store_home(gcode::kHomeParameter);
  set_data("G10 L2 P1 X1");
  EXPECT_EQ(coordinates.home(gcode::kHomeParameter)[0], 9.0);
  EXPECT_EQ(parameters.at(gcode::kHomeParameter), 10.0);
}

// The parameters behind the last system belong to no system, and those beyond 5602 do not exist.
TEST_F(GcodeCoordinates, HaveTheFirstSystemWhereAProgramHasSetAnUnknownOne) {
  for (const double unknown : {10.0, 99.0, 0.0, -3e6, 1e300}) {
    parameters.at(gcode::kSystemParameter) = unknown;
    set_data("G10 L2 P0 X1");
    expect_place({9, 5, 3, 30, 20, 10}, "G10 L2 P0");
    EXPECT_EQ(coordinates.value_of("_coord_system"), 540.0);
    coordinates.begin_program(kMachine);
    EXPECT_EQ(parameters.at(gcode::kSystemParameter), 1.0);
  }
}

TEST_F(GcodeCoordinates, StayFromProgramToProgram) {
  set_data("G10 L2 P2 X2");
  coordinates.set_system(block("G55"));
  coordinates.set_g92(block("G92 X0"));
  coordinates.begin_program(kMachine);
  EXPECT_EQ(sink.last<SetG5xOffset>().index, 2);
  EXPECT_EQ(coordinates.place()[0], 0.0);
  coordinates.end_program();
  EXPECT_EQ(coordinates.system(), 1);
  EXPECT_EQ(coordinates.place()[0], 2.0) << "of G92 alone";
}

TEST_F(GcodeCoordinates, AnswerPlacesInTheUnitsOfTheProgram) {
  set_data("G10 L2 P1 X-15.4");
  modes.set_units_and_plane(block("G20"));
  EXPECT_DOUBLE_EQ(*coordinates.value_of("_x"), 1.0);
  EXPECT_DOUBLE_EQ(*coordinates.value_of(gcode::kPlaceParameter), 1.0);
  EXPECT_DOUBLE_EQ(*coordinates.value_of("_abs_x"), 10.0 / 25.4);
  EXPECT_DOUBLE_EQ(*coordinates.value_of("_abs_a"), 30.0) << "degrees";
  EXPECT_EQ(coordinates.value_of("_xy"), std::nullopt);
  EXPECT_EQ(coordinates.value_of(gcode::kPlaceParameter + 6), std::nullopt);
}

}  // namespace
}  // namespace armature::test
