#include "controller/language/gcode/execute/coolant.hpp"

#include <gtest/gtest.h>

#include "tests/controller/language/gcode/parts_rig.hpp"

namespace armature::test {
namespace {

using gcode::Flood;
using gcode::Mist;

struct GcodeCoolant : testing::Test, GcodeParts {};

TEST_F(GcodeCoolant, HasMistBesideFlood) {
  coolant.set(block("M7"));
  coolant.set(block("M8"));
  EXPECT_TRUE((sink.made<Mist, Flood>()));
  EXPECT_EQ(coolant.value_of("_mist"), 1.0);
  EXPECT_EQ(coolant.value_of("_flood"), 1.0);
  sink.clear();
  coolant.set(block("M9"));
  EXPECT_TRUE((sink.made<Mist, Flood>()));
  EXPECT_EQ(coolant.value_of("_mist"), 0.0);
}

TEST_F(GcodeCoolant, RestoresWhatWasOnAndSwitchesOffOnlyBoth) {
  coolant.set(block("M8"));
  coolant.restore({.mist = true});
  EXPECT_TRUE(coolant.active().mist && coolant.active().flood);
  sink.clear();
  coolant.restore({.mist = true});
  EXPECT_TRUE(sink.calls.empty());
  coolant.restore({});
  EXPECT_TRUE((sink.made<Mist, Flood>()));
  EXPECT_FALSE(coolant.active().mist || coolant.active().flood);
}

TEST_F(GcodeCoolant, SwitchesOffWhatIsOnAtTheEnd) {
  coolant.end_program();
  EXPECT_TRUE(sink.calls.empty());
  coolant.set(block("M8"));
  coolant.end_program();
  EXPECT_TRUE((sink.made<Flood, Flood>()));
  EXPECT_FALSE(sink.last<Flood>().on);
}

}  // namespace
}  // namespace armature::test
