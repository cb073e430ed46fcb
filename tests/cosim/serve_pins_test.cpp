#include "cosim/serve/pins.hpp"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <string>

#include "controller/regs/soc_map.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

struct Port {
  bool input = false;
  int bits = 1;
  friend bool operator==(const Port&, const Port&) = default;
};

void PrintTo(const Port& port, std::ostream* out) {
  *out << (port.input ? "input" : "output") << " of " << port.bits;
}

// From the source of the logic: everything but clocks, reset and bus.
std::map<std::string, Port> ports_of_the_module() {
  std::string text = read_text_file(ARMATURE_SOURCE_DIR "/rtl/soc/arm_soc.sv");
  text = text.substr(0, text.find(");\n"));
  const std::regex port{R"(\n\s*(input|output)\s+logic\s+(?:\[([\w:]+)(-1)?:0\]\s*)?(\w+))"};
  std::map<std::string, Port> ports;
  for (std::sregex_iterator it{text.begin(), text.end(), port}, end; it != end; ++it) {
    const std::smatch& found = *it;
    const std::string name = found[4];
    if (name == "clk_i" || name == "clk_io_i" || name == "io_active_o" || name == "rst_ni") continue;
    if (name.starts_with("s_axi_")) continue;
    const std::string top = found[2];
    int bits = 1;
    if (top == "soc_map_pkg::NumIrqs") {
      bits = static_cast<int>(regs::soc::kNumIrqs);
    } else if (!top.empty()) {
      bits = std::stoi(top) + 1;
    }
    ports[name] = {found[1] == "input", bits};
  }
  return ports;
}

TEST(ServePins, AreThePortsOfTheModule) {
  std::map<std::string, Port> served;
  for (const Pin& pin : pins()) served[std::string{pin.name}] = {pin.is_input(), pin.bits};
  EXPECT_EQ(served.size(), pins().size()) << "a name is there twice";
  EXPECT_GE(served.size(), 20u);
  EXPECT_EQ(served, ports_of_the_module());
}

TEST(ServePins, EachInputIsItsOwn) {
  for (const Pin& pin : pins()) {
    if (!pin.is_input()) continue;
    for (const std::uint32_t level : {std::uint32_t{0}, std::uint32_t{1}, pin.most()}) {
      FabricInputs inputs;
      pin.set(inputs, level);
      EXPECT_EQ(pin.get(inputs, {}), level) << pin.name;
      for (const Pin& other : pins()) {
        if (other.name == pin.name) continue;
        EXPECT_EQ(other.get(inputs, {}), other.get({}, {})) << pin.name << " moves " << other.name;
      }
    }
  }
}

TEST(ServePins, EachOutputIsItsOwn) {
  FabricOutputs outputs;
  outputs.step = 1, outputs.dir = 2, outputs.servo_on = 3, outputs.irq = 4, outputs.gpio = 0x8001;
  outputs.trigger = outputs.pwm = true, outputs.uart_txd = false;
  const std::map<std::string, std::uint32_t> expected = {{"step_o", 1}, {"dir_o", 2},       {"servo_on_o", 3},
                                                         {"irq_o", 4},  {"gpio_o", 0x8001}, {"trigger_o", 1},
                                                         {"pwm_o", 1},  {"uart_txd_o", 0}};
  std::map<std::string, std::uint32_t> got;
  for (const Pin& pin : pins()) {
    if (!pin.is_input()) got[std::string{pin.name}] = pin.get({}, outputs);
  }
  EXPECT_EQ(got, expected);
}

TEST(ServePins, AreFoundByTheirWholeName) {
  EXPECT_EQ(find_pin("step_o")->name, "step_o");
  EXPECT_EQ(find_pin("step"), nullptr);
  EXPECT_EQ(find_pin("step_o "), nullptr);
  EXPECT_EQ(find_pin(""), nullptr);
}

}  // namespace
}  // namespace armature::cosim
