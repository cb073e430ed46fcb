#include "controller/pendant/parts/telemetry_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "controller/pendant/protocol/message_pages.hpp"
#include "tests/controller/pendant/parts_bench.hpp"

namespace armature::pendant {
namespace {

class TelemetryPagesTest : public testing::Test {
 protected:
  [[nodiscard]] std::int32_t value(Page page, std::uint8_t index = 0) const {
    return pages.value(static_cast<std::uint8_t>(static_cast<std::uint8_t>(page) + index), Cycles{});
  }
  // Pages that are sent at this time, found from the room that they leave.
  [[nodiscard]] std::size_t sent(std::int64_t at_ms) {
    const std::size_t before = room();
    pages.send_when_due(bench.parts.line, Cycles{at_ms * 50'000});
    return before - room();
  }
  [[nodiscard]] std::size_t room() const {
    std::size_t frames = 0;
    while (bench.parts.line.has_room(frames + 1)) ++frames;
    return frames;
  }

  test::PartsBench bench{PendantConfig{.profile = Profile::kExtended}};
  TelemetryPages& pages = bench.parts.telemetry;
};

TEST_F(TelemetryPagesTest, TheFirstPageHasStateCoordinatesDrivesAndProfile) {
  bench.switch_on();
  bench.parts.manual.select(System::kTool);
  const std::int32_t page = value(Page::kState);
  EXPECT_EQ(kStateState.of(page), static_cast<std::int32_t>(State::kReady));
  EXPECT_EQ(kStateCoordinates.of(page), static_cast<std::int32_t>(System::kTool));
  EXPECT_EQ(kStateDrivesOn.of(page), 1);
  EXPECT_EQ(kStateExtended.of(page), 1);
}

TEST_F(TelemetryPagesTest, TheOthersHavePositionProgramAndItsMessage) {
  bench.position.set(2, Radians{}, Radians{0.5});
  EXPECT_GT(value(Page::kJoint, 2), 0);
  EXPECT_EQ(value(Page::kJoint, 1), 0);
  EXPECT_NE(value(Page::kTool), 0);
  EXPECT_EQ(value(Page::kProgram), 0);
  bench.program.set(bench.waiting, Ticks{});
  bench.notify(Faulted{.cause = FaultCause::kDriveAlarm, .axis = 3});
  EXPECT_EQ(value(Page::kAlarm), static_cast<std::int32_t>(FaultCause::kDriveAlarm) + 256 * 3);
  const MessageHeader message = message_header(value(Page::kMessage));
  EXPECT_EQ(message.kind, MessageKind::kAlarm);
  EXPECT_EQ(message.number, 1);
  EXPECT_EQ(value(Page::kMessageText), 'a' + ' ' * 256 + 'f' * 65'536);  // a fault ...
}

TEST_F(TelemetryPagesTest, AreSentAtOnceAndInEachPeriod) {
  EXPECT_EQ(sent(0), 0u);
  pages.select(kPageGroups[1], 20, Cycles{});
  EXPECT_TRUE(pages.periodic());
  EXPECT_EQ(sent(0), 6u);
  EXPECT_EQ(sent(19), 0u);
  EXPECT_EQ(sent(20), 6u);
  pages.select(kPageGroups[1], 19, Cycles{});
  EXPECT_FALSE(pages.periodic());
  EXPECT_EQ(sent(40), 0u);
}

TEST_F(TelemetryPagesTest, AreNotSentInPart) {
  pages.select(kAllPageGroups, 20, Cycles{});
  EXPECT_EQ(sent(0), std::size_t{kPages});
  EXPECT_LT(room(), std::size_t{kPages});
  EXPECT_EQ(sent(20), 0u);
}

}  // namespace
}  // namespace armature::pendant
