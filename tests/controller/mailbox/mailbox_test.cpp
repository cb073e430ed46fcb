// The memory between the controller and its host: round trips of values, the rings, and the committed layout.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include "controller/mailbox/codec.hpp"
#include "controller/mailbox/command_fields.hpp"
#include "controller/mailbox/controller_end.hpp"
#include "controller/mailbox/event_fields.hpp"
#include "controller/mailbox/host_end.hpp"
#include "controller/mailbox/memory.hpp"
#include "controller/mailbox/telemetry_fields.hpp"
#include "controller/mailbox/wire.hpp"

namespace armature::mailbox {
namespace {

std::mt19937_64 engine{20'261'122};

// Gives every member of a value that has a field in the block a random value.
struct Fill {
  template <class Value>
  void operator()(auto&, Value& value) const {
    if constexpr (std::is_same_v<Value, Tag>) {
      value = Tag::from_word(static_cast<u32>(engine()));
    } else if constexpr (std::is_same_v<Value, bool>) {
      value = engine() % 2 == 0;
    } else if constexpr (Unit<Value>) {
      value = Value{static_cast<typename Value::rep>(static_cast<std::int32_t>(engine())) / 3};
    } else if constexpr (std::is_same_v<Value, Eigen::Vector3d> || std::is_same_v<Value, Eigen::Matrix3d>) {
      for (Eigen::Index i = 0; i < value.size(); ++i) value.data()[i] = std::normal_distribution{0.0, 1e3}(engine);
    } else if constexpr (requires { value.size(); }) {
      for (auto& element : value) (*this)(value, element);
    } else if constexpr (std::is_floating_point_v<Value>) {
      value = std::normal_distribution{0.0, 1e3}(engine);
    } else {
      value = static_cast<Value>(engine() % 200);
    }
  }
  template <class Value>
  void optional(auto& has, auto& wire, std::optional<Value>& value) const {
    value.reset();
    if (engine() % 2 == 0) (*this)(wire, value.emplace());
    (void)has;
  }
};

template <class Value>
Value random_value() {
  Value value{};
  typename FieldsOf<Value>::Block unused{};
  FieldsOf<Value>::transfer(Fill{}, unused, value);
  return value;
}

template <class Value>
typename FieldsOf<Value>::Block block_of(const Value& value) {
  typename FieldsOf<Value>::Block block{};
  FieldsOf<Value>::transfer(Encode{}, block, value);
  return block;
}

// Bytes of a block that were not 0 in any of its values so far: a field that nobody writes stays 0.
template <class Block>
class WrittenBytes {
 public:
  void add(const Block& block) {
    std::array<u8, sizeof(Block)> bytes{};
    std::memcpy(bytes.data(), &block, sizeof(block));
    for (std::size_t i = 0; i < bytes.size(); ++i) seen_[i] |= bytes[i];
  }
  void expect_all_fields() const {
    for (const Field& field : LayoutOf<Block>::kFields) {
      u8 any = 0;
      for (std::size_t i = 0; i < field.bytes; ++i) any |= seen_[field.offset + i];
      const bool reserved = std::string{field.name}.starts_with("reserved");
      EXPECT_EQ(any == 0, reserved) << LayoutOf<Block>::kName << "::" << field.name;
    }
  }

 private:
  std::array<u8, sizeof(Block)> seen_{};
};

template <class Variant, class... Values>
void expect_round_trips(std::type_identity<std::variant<Values...>>) {
  const auto round_trip = []<class Value>(std::type_identity<Value>) {
    WrittenBytes<typename FieldsOf<Value>::Block> written;
    for (int i = 0; i < 200; ++i) {
      const Value value = random_value<Value>();
      const auto block = encode(Variant{value});
      const std::optional<Variant> decoded = decode(block);
      ASSERT_TRUE(decoded);
      ASSERT_TRUE(std::holds_alternative<Value>(*decoded));
      const auto again = encode(*decoded);
      ASSERT_EQ(std::memcmp(&block, &again, sizeof(block)), 0);
      const auto fields = block_of(value), fields_again = block_of(std::get<Value>(*decoded));
      ASSERT_EQ(std::memcmp(&fields, &fields_again, sizeof(fields)), 0);
      written.add(fields);
    }
    written.expect_all_fields();
  };
  (round_trip(std::type_identity<Values>{}), ...);
}

TEST(Mailbox, EveryCommandComesBackAsItWas) {
  expect_round_trips<Command>(std::type_identity<Command>{});
}

TEST(Mailbox, EveryEventComesBackAsItWas) {
  expect_round_trips<Event>(std::type_identity<Event>{});
}

TEST(Mailbox, ValuesLieWhereTheLayoutSays) {
  CartesianMove move;
  move.kind = SegmentRequest::Kind::kCircle;
  move.target.frame = kToolFrame;
  move.target.position_mm = {1, 2, 3};
  Eigen::Matrix3d rotation;
  rotation << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  move.target.rotation = rotation;
  move.via_mm = {4, 5, 6};
  move.limits.speed_mm_s = 250;
  move.limits.turn_jerk_rad_s3 = 17;
  move.blend_mm = 8;
  move.exact_stop = true;
  move.tag = 0x0012'3456;
  const CommandBlock block = encode(Command{move});
  EXPECT_EQ(block.kind, 3u);
  const auto at = [&block]<class T>(std::size_t offset, T) {
    T value{};
    std::memcpy(&value, block.body.data() + offset, sizeof(value));
    return value;
  };
  EXPECT_EQ(at(0, u32{}), 0x0012'3456u);
  EXPECT_EQ(at(5, u8{}), 255);
  EXPECT_EQ(at(6, u8{}), 1);
  EXPECT_EQ(at(7, u8{}), 2);
  EXPECT_EQ(at(16, f64{}), 2);
  EXPECT_EQ(at(40, f64{}), 2);  // row 1, column 2
  EXPECT_EQ(at(56, f64{}), 4);  // row 2, column 1
  EXPECT_EQ(at(112, f64{}), 5);
  EXPECT_EQ(at(128, f64{}), 250);
  EXPECT_EQ(at(168, f64{}), 17);
  EXPECT_EQ(at(176, f64{}), 8);
  EXPECT_EQ(at(194, u8{}), 1);
}

TEST(Mailbox, ABlockOfAnUnknownKindIsNoCommandAndNoEvent) {
  for (const u32 kind : {0u, 17u, 0xFFFF'FFFFu}) {
    EXPECT_FALSE(decode(CommandBlock{.kind = kind}));
    EXPECT_FALSE(decode(EventBlock{.kind = kind}));
  }
}

struct MailboxTest : testing::Test {
  std::unique_ptr<Memory> memory = std::make_unique<Memory>();
  HostEnd host{*memory};
};

TEST_F(MailboxTest, TelemetryIsSeenOnceForEachTick) {
  Core0Writer core0{*memory};
  EXPECT_FALSE(host.new_telemetry());
  for (int tick = 0; tick < 100; ++tick) {
    const Telemetry telemetry = random_value<Telemetry>();
    core0.on_tick(telemetry);
    const std::optional<Telemetry> seen = host.new_telemetry();
    ASSERT_TRUE(seen);
    const TelemetryBlock expected = block_of(telemetry), got = block_of(*seen);
    EXPECT_EQ(std::memcmp(&expected, &got, sizeof(got)), 0);
    EXPECT_FALSE(host.new_telemetry());
  }
  memory->telemetry.published += 1;  // it is being written
  EXPECT_FALSE(host.new_telemetry());
}

TEST_F(MailboxTest, AnEventThatFindsNoRoomIsCounted) {
  Core1Writer core1{*memory};
  constexpr u32 kRoom = Core1Events::kCapacity;
  for (u32 i = 0; i < kRoom; ++i) core1.on_event(IoDone{.tag = i});
  EXPECT_EQ(host.lost_events(), 0u);
  core1.on_event(IoDone{.tag = kRoom});
  core1.on_event(IoDone{.tag = kRoom + 1});
  EXPECT_EQ(host.lost_events(), 2u);
  for (u32 i = 0; i < kRoom; ++i) {
    const std::optional<Event> event = host.next_event();
    ASSERT_TRUE(event);
    EXPECT_EQ(std::get<IoDone>(*event).tag, i);
  }
  EXPECT_FALSE(host.next_event());
}

TEST_F(MailboxTest, ARingGoesOnWhenItsCountersWrap) {
  memory->core1_events.written = memory->core1_events.read = 0xFFFF'FFF0;
  Core1Writer core1{*memory};
  for (u32 i = 0; i < 200; ++i) {
    core1.on_event(IoDone{.tag = i});
    EXPECT_EQ(std::get<IoDone>(host.next_event().value()).tag, i);
  }
  EXPECT_EQ(host.lost_events(), 0u);
}

TEST_F(MailboxTest, CommandsStayInTheirRingWhileTheInboxIsFull) {
  Inboxes inboxes;
  for (u32 i = 0; i < 16; ++i) ASSERT_TRUE(host.submit(Source::kScenario, ClearFault{i}));
  receive_commands(*memory, inboxes);
  EXPECT_TRUE(inbox_of(inboxes, Source::kScenario).full());
  ASSERT_TRUE(host.submit(Source::kScenario, ClearFault{16}));
  receive_commands(*memory, inboxes);
  for (u32 i = 0; i < 17; ++i) {
    const std::optional<Command> command = inbox_of(inboxes, Source::kScenario).try_pop();
    ASSERT_TRUE(command);
    EXPECT_EQ(std::get<ClearFault>(*command).tag, i);
    receive_commands(*memory, inboxes);
  }
}

// ---- LAYOUT.md

template <class Block>
void describe(std::ostream& out, const std::string& about) {
  out << "\n## " << LayoutOf<Block>::kName << ", " << sizeof(Block) << " bytes" << about << "\n\n"
      << "| offset | type | field | meaning |\n|---:|---|---|---|\n";
  for (const Field& field : LayoutOf<Block>::kFields) {
    out << "| " << field.offset << " | " << field.type << " | `" << field.name << "` | " << field.meaning << " |\n";
  }
}

template <class Value>
void describe_kind(std::ostream& out) {
  describe<typename FieldsOf<Value>::Block>(out, ", kind " + std::to_string(FieldsOf<Value>::kKind));
}

template <class... Values>
void describe_kinds(std::ostream& out, std::type_identity<std::variant<Values...>>) {
  (describe_kind<Values>(out), ...);
}

std::string layout() {
  std::ostringstream out;
  out << "# Layout of the mailbox memory, version " << kLayoutVersion << "\n\n"
      << "Written by `tests/controller/mailbox/mailbox_test.cpp`: `ARMATURE_WRITE_LAYOUT=FILE` writes a new one.\n\n"
      << "Numbers are little-endian: `u8` to `u32` unsigned, `i64` signed, `f64` IEEE 754 binary64; `x3` is an array "
         "of\n"
      << "three; `f64x9` is a matrix, row by row. A ring is `u32 written, read, lost, reserved` and its slots: 16 of\n"
      << "`CommandBlock`, " << Core0Events::kCapacity << " (core 0) and " << Core1Events::kCapacity
      << " (core 1) of `EventBlock`. Block n lies in slot n modulo their number.\n";
  describe<Memory>(out, "");
  describe<CommandBlock>(out, "");
  describe_kinds(out, std::type_identity<Command>{});
  describe<EventBlock>(out, "");
  describe_kinds(out, std::type_identity<Event>{});
  describe<TelemetryBlock>(out, "");
  return out.str();
}

TEST(Mailbox, TheCommittedLayoutIsThatOfTheBlocks) {
  if (const char* file = std::getenv("ARMATURE_WRITE_LAYOUT")) std::ofstream{file} << layout();
  std::ifstream file{std::string{ARMATURE_SOURCE_DIR} + "/controller/mailbox/LAYOUT.md"};
  const std::string committed{std::istreambuf_iterator<char>{file}, {}};
  EXPECT_EQ(committed, layout());
}

}  // namespace
}  // namespace armature::mailbox
