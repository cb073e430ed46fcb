#include "cosim/scenario/fault_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cosim/scenario/kinds.hpp"

namespace armature::cosim {
namespace {

using Parameters = std::vector<std::pair<std::string, KeyValue>>;

Parameters parameters(const FaultKind& kind) {
  Parameters list;
  for (const NamedValue& parameter : fault_parameters(kind)) list.emplace_back(parameter.key, parameter.value);
  return list;
}

TEST(FaultText, SaysInWordsWhatTheScenarioSaysInKeys) {
  EXPECT_EQ(fault_text({.kind = PulseLoss{.axis = 3, .count = 500}}), "pulse_loss of axis 3, 500 pulses");
  EXPECT_EQ(fault_text({.kind = SlowCore{.compute_us = 62.5}}), "slow_core, 62.5 us a tick");
  EXPECT_EQ(fault_text({.kind = Estop{.duration_s = 0.02}}), "estop for 0.02 s");
  EXPECT_EQ(fault_text({.kind = ClockStop{.duration_s = 0.02}}), "clock_stop for 0.02 s");
  EXPECT_EQ(fault_text({.kind = StrayWrite{.address = 0x4280'0000, .data = 0xA5}}),
            "stray_write of 0xA5 to 0x42800000");
  EXPECT_EQ(fault_text({.kind = BlockHang{.clock = ClockGroup::kEncoder}}), "block_hang of clock encoder");
  EXPECT_EQ(fault_text({.kind = EncoderStuck{.axis = 2, .line = EncoderLine::kB, .level = 1, .duration_s = 0.5}}),
            "encoder_stuck of axis 2, line b = 1 for 0.5 s");
  EXPECT_EQ(
      fault_text({.kind = SwitchBounce{.axis = 2, .which = AxisSwitch::kLimitPos, .period_us = 50, .duration_s = 0.5}}),
      "switch_bounce of axis 2, limit_pos, 50 us for 0.5 s");
  EXPECT_EQ(fault_text({.kind = CollisionTorque{.axis = 2, .torque_nm = -40.5, .duration_s = 0.5}}),
            "collision_torque of axis 2, -40.5 N m for 0.5 s");
  EXPECT_EQ(fault_text({.kind = CoreOneStuck{}}), "core1_stuck");
  EXPECT_EQ(fault_text({.kind = UartOverrun{.duration_s = 0.5}}), "uart_overrun for 0.5 s");
  EXPECT_EQ(fault_text({.kind = RegisterFlip{.address = 0x4280'0000, .bit = 7}}),
            "register_flip of bit 7 at 0x42800000");
  EXPECT_EQ(fault_text({.kind = FlopFlip{.flop = "u_xbar.busy_q", .bit = 3}}), "flop_flip of bit 3 of u_xbar.busy_q");
  EXPECT_EQ(fault_text({.kind = MemoryFlip{.symbol = "host_memory", .offset = 16, .bit = 31}}),
            "memory_flip of bit 31 at host_memory+16");
}

TEST(FaultText, GivesTheKeysOfTheKindWithTheirValues) {
  EXPECT_EQ(parameters(PulseLoss{.axis = 3, .count = 500}),
            (Parameters{{"axis", std::int64_t{3}}, {"count", std::int64_t{500}}}));
  EXPECT_EQ(parameters(SlowCore{.compute_us = 60}), (Parameters{{"compute_us", 60.0}}));
  EXPECT_EQ(parameters(Estop{.duration_s = 0.02}), (Parameters{{"duration_s", 0.02}}));
  EXPECT_EQ(parameters(BlockHang{.clock = ClockGroup::kMotion}), (Parameters{{"clock", std::string{"motion"}}}));
}

// Also those that a later change adds.
TEST(FaultText, EveryKindHasANameOfItsOwnAndItsDurationIsAKey) {
  std::set<std::string_view> names;
  for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
    const FaultKind kind = Kind{};
    const std::string_view name = fault_kind_name(kind);
    EXPECT_FALSE(name.empty());
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_THAT(fault_text({.kind = kind}), testing::StartsWith(std::string{name})) << name;
    bool has_duration = false;
    for (const auto& [key, value] : parameters(kind)) has_duration |= key == "duration_s";
    EXPECT_EQ(fault_duration_s(kind).has_value(), has_duration) << name;
  });
}

}  // namespace
}  // namespace armature::cosim
