#include "cosim/logic/pin_table.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string_view>

namespace armature::cosim {
namespace {

TEST(PinTable, HasEachPortOnce) {
  std::set<std::string_view> names;
  for (const Pin& pin : pins()) {
    EXPECT_TRUE(names.insert(pin.name).second) << pin.name;
    EXPECT_TRUE(pin.name.ends_with(pin.is_input() ? "i" : "o")) << pin.name;
  }
  EXPECT_GE(names.size(), 20u);
}

TEST(PinTable, EachInputIsItsOwn) {
  for (const Pin& pin : pins()) {
    if (!pin.is_input()) continue;
    for (const std::uint32_t level : {std::uint32_t{0}, std::uint32_t{1}, pin.max_value()}) {
      SocInputs inputs;
      pin.set(inputs, level);
      EXPECT_EQ(pin.get(inputs, {}), level) << pin.name;
      for (const Pin& other : pins()) {
        if (other.name == pin.name) continue;
        EXPECT_EQ(other.get(inputs, {}), other.get({}, {})) << pin.name << " moves " << other.name;
      }
    }
  }
}

TEST(PinTable, AnOutputShowsItsOwnLevel) {
  SocOutputs outputs;
  outputs.step = 0x3F, outputs.irq = 5, outputs.gpio = 0x8001, outputs.uart_txd = false;
  const std::map<std::string_view, std::uint32_t> changed = {
      {"step_o", 0x3F}, {"irq_o", 5}, {"gpio_o", 0x8001}, {"uart_txd_o", 0}};
  std::size_t found = 0;
  for (const Pin& pin : pins()) {
    const auto expected = changed.find(pin.name);
    found += expected != changed.end();
    EXPECT_EQ(pin.get({}, outputs), expected != changed.end() ? expected->second : pin.get({}, {})) << pin.name;
  }
  EXPECT_EQ(found, changed.size());
}

TEST(PinTable, FindsAPinByItsWholeName) {
  EXPECT_EQ(find_pin("step_o")->name, "step_o");
  EXPECT_EQ(find_pin("step"), nullptr);
  EXPECT_EQ(find_pin("step_o "), nullptr);
  EXPECT_EQ(find_pin(""), nullptr);
}

}  // namespace
}  // namespace armature::cosim
