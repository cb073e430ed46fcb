// The memory between the controller and its host: round trips of values, the rings, and the committed layout.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "controller/host_memory/controller_side.hpp"
#include "controller/host_memory/host_side.hpp"
#include "controller/host_memory/layout.hpp"
#include "controller/host_memory/memory.hpp"
#include "controller/host_memory/slot.hpp"
#include "controller/host_memory/wire.hpp"

namespace armature::host_memory {
namespace {

std::mt19937_64 engine{20'261'122};

template <class T>
T random_value();

struct Fill {
  template <class T>
  void operator()(const char*, T& value) const {
    value = random_value<T>();
  }
};

// A value in which all members are random. Counts are small, so that they fit.
template <class T>
T random_value() {
  T value{};
  if constexpr (std::is_same_v<T, Tag>) {
    value = Tag::from_word(static_cast<std::uint32_t>(engine()));
  } else if constexpr (std::is_same_v<T, bool>) {
    value = engine() % 2 == 0;
  } else if constexpr (Unit<T>) {
    value = T{static_cast<typename T::rep>(static_cast<std::int32_t>(engine())) / 3};
  } else if constexpr (std::is_floating_point_v<T>) {
    value = std::normal_distribution{0.0, 1e3}(engine);
  } else if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(engine() % kWordsOf<T>.size());
  } else if constexpr (Scalar<T>) {
    value = static_cast<T>(engine() % 5);
  } else if constexpr (kIsMatrix<T>) {
    for (Eigen::Index i = 0; i < value.size(); ++i) value.data()[i] = random_value<double>();
  } else if constexpr (Optional<T>) {
    if (engine() % 2 == 0) value = random_value<typename T::value_type>();
  } else if constexpr (HasMembers<T>) {
    for_each_member(value, Fill{});
  } else {
    for (auto& element : value) element = random_value<typename T::value_type>();
  }
  return value;
}

template <class T>
std::array<std::uint8_t, kWireSize<T>> bytes_of(const T& value) {
  std::array<std::uint8_t, kWireSize<T>> bytes{};
  EXPECT_EQ(put(bytes.data(), 0, value), end_of<T>(0));
  return bytes;
}

// Collects the fields of a type, with their full names.
struct NamedField {
  Field field;
  std::string name;
};
std::string full_name(const NamePart* part) {
  if (part->outer == nullptr) return {};
  const std::string outer = full_name(part->outer);
  if (part->name.empty()) return outer + "[" + std::to_string(part->index) + "]";
  return outer.empty() ? std::string{part->name} : outer + "." + std::string{part->name};
}
template <class T>
std::vector<NamedField> fields_of() {
  std::vector<NamedField> fields;
  auto collect = [&fields](const Field& field) { fields.push_back({field, full_name(field.name)}); };
  EXPECT_EQ(describe<T>(0, NamePart{}, collect), end_of<T>(0));
  return fields;
}

template <class Variant, class... Messages>
void expect_round_trips(std::type_identity<std::variant<Messages...>>) {
  const auto round_trip = []<class Message>(std::type_identity<Message>) {
    std::array<std::uint8_t, kWireSize<Message>> written{};
    for (int i = 0; i < 200; ++i) {
      const auto value = random_value<Message>();
      const auto slot = encode(Variant{value});
      const std::optional<Variant> decoded = decode(slot);
      ASSERT_TRUE(decoded);
      ASSERT_TRUE(std::holds_alternative<Message>(*decoded));
      const auto again = encode(*decoded);
      ASSERT_EQ(std::memcmp(&slot, &again, sizeof(slot)), 0);
      const auto bytes = bytes_of(value), bytes_again = bytes_of(std::get<Message>(*decoded));
      ASSERT_EQ(bytes, bytes_again);
      for (std::size_t at = 0; at < bytes.size(); ++at) written[at] |= bytes[at];
    }
    // Each field takes bytes, and no byte belongs to two of them.
    std::size_t end = 0;
    for (const auto& [field, name] : fields_of<Message>()) {
      EXPECT_GE(field.offset, end) << name;
      end = field.offset + field.bytes;
      const std::uint8_t* first = written.data() + field.offset;
      EXPECT_TRUE(std::any_of(first, first + field.bytes, [](std::uint8_t byte) { return byte != 0; })) << name;
    }
    EXPECT_LE(end, kWireSize<Message>);
  };
  (round_trip(std::type_identity<Messages>{}), ...);
}

TEST(HostMemory, EveryCommandComesBackAsItWas) {
  expect_round_trips<Command>(std::type_identity<Command>{});
}

TEST(HostMemory, EveryEventComesBackAsItWas) {
  expect_round_trips<Event>(std::type_identity<Event>{});
}

TEST(HostMemory, ScalarsLieAtMultiplesOfTheirSizeInTheOrderOfTheMembers) {
  Jog jog;
  jog.kind = Jog::Kind::kTool;
  jog.joint_rad_s[1] = 2;
  jog.frame = kToolFrame;
  jog.move_mm_s = {3, 4, 5};
  jog.duration = Ticks{7};
  jog.profile = ProfileKind::kSCurve;
  jog.tool.turn_jerk_rad_s3 = 8;
  jog.tag = 0x0012'3456;
  const CommandSlot slot = encode(Command{jog});
  EXPECT_EQ(slot.kind, 11u);
  const auto at = [&slot]<class T>(std::size_t offset, T) {
    T value{};
    std::memcpy(&value, slot.body.data() + offset, sizeof(value));
    return value;
  };
  EXPECT_EQ(at(0, std::uint8_t{}), 1);     // kind
  EXPECT_EQ(at(16, double{}), 2);          // joint_rad_s
  EXPECT_EQ(at(56, std::uint8_t{}), 255);  // frame.index
  EXPECT_EQ(at(72, double{}), 4);          // move_mm_s
  EXPECT_EQ(at(112, std::int64_t{}), 7);   // duration
  EXPECT_EQ(at(120, std::uint8_t{}), 1);   // profile
  EXPECT_EQ(at(160, double{}), 8);         // tool.turn_jerk_rad_s3
  EXPECT_EQ(at(168, std::uint32_t{}), 0x0012'3456u);
}

TEST(HostMemory, AMatrixIsWrittenRowByRow) {
  Eigen::Matrix3d matrix;
  matrix << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  std::array<double, 9> numbers{};
  std::array<std::uint8_t, sizeof(numbers)> bytes{};
  EXPECT_EQ(put(bytes.data(), 0, matrix), bytes.size());
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  EXPECT_EQ(numbers, (std::array<double, 9>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(HostMemory, AnUnknownKindIsNoCommandAndNoEvent) {
  for (const std::uint32_t kind : {0u, 17u, 0xFFFF'FFFFu}) {
    CommandSlot command;
    EventSlot event;
    command.kind = event.kind = kind;
    EXPECT_FALSE(decode(command));
    EXPECT_FALSE(decode(event));
  }
}

TEST(HostMemory, ABadFlagEnumeratorOrCountIsNoCommandAndNoEvent) {
  const CommandSlot output = encode(Command{SetOutput{.pin = 3, .level = true}});
  CommandSlot bad = output;
  ASSERT_TRUE(decode(bad));
  bad.body[1] = 2;  // level
  EXPECT_FALSE(decode(bad));

  bad = encode(Command{Stop{}});
  bad.body[0] = kWordsOf<Stop::Kind>.size();
  EXPECT_FALSE(decode(bad));

  ProgramNoted note;
  note.text_size = ProgramNoted::kMaxText;
  EXPECT_TRUE(decode(encode(Event{note})));
  ++note.text_size;
  EXPECT_FALSE(decode(encode(Event{note})));
}

// What decode() accepts is a value: it comes back from its own bytes.
template <class... Messages>
int count_accepted(std::type_identity<std::variant<Messages...>>) {
  using Variant = std::variant<Messages...>;
  int accepted = 0;
  for (int i = 0; i < 50'000; ++i) {
    Slot<Variant> slot;
    slot.kind = static_cast<std::uint32_t>(1 + engine() % sizeof...(Messages));
    const std::uint64_t largest = 1 + engine() % 4;  // of a byte, so that many flags and enumerators are good
    for (std::uint8_t& byte : slot.body) byte = static_cast<std::uint8_t>(engine() % (largest + 1));
    const std::optional<Variant> message = decode(slot);
    if (!message) continue;
    ++accepted;
    const std::optional<Variant> again = decode(encode(*message));
    EXPECT_TRUE(again && again->index() == message->index());
  }
  return accepted;
}
TEST(HostMemory, RandomBytesAreRefusedOrAValue) {
  EXPECT_GT(count_accepted(std::type_identity<Command>{}), 1000);
  EXPECT_GT(count_accepted(std::type_identity<Event>{}), 1000);
}

struct HostMemoryTest : testing::Test {
  std::unique_ptr<HostMemory> memory = std::make_unique<HostMemory>();
  HostSide host{*memory};
};

TEST_F(HostMemoryTest, TelemetryIsSeenOnceForEachTick) {
  Core0Writer core0{*memory};
  EXPECT_FALSE(host.new_telemetry());
  for (int tick = 0; tick < 100; ++tick) {
    const Telemetry telemetry = random_value<Telemetry>();
    core0.on_tick(telemetry);
    const std::optional<Telemetry> seen = host.new_telemetry();
    ASSERT_TRUE(seen);
    const auto expected = bytes_of(telemetry), got = bytes_of(*seen);
    EXPECT_EQ(expected, got);
    EXPECT_FALSE(host.new_telemetry());
  }
  memory->telemetry.published += 1;  // it is being written
  EXPECT_FALSE(host.new_telemetry());
}

// A controller that is out of its mind may write anything.
TEST_F(HostMemoryTest, TelemetryWithAStateThatIsNoneIsNotRead) {
  Core0Writer core0{*memory};
  Telemetry seen = random_value<Telemetry>();
  const auto before = bytes_of(seen);
  core0.on_tick(random_value<Telemetry>());
  for (std::uint8_t& byte : memory->telemetry.body) byte = 0x56;
  EXPECT_FALSE(host.read_new(seen));
  EXPECT_EQ(bytes_of(seen), before);
  const Telemetry next = random_value<Telemetry>();
  core0.on_tick(next);
  EXPECT_TRUE(host.read_new(seen));
  EXPECT_EQ(bytes_of(seen), bytes_of(next));
}

TEST_F(HostMemoryTest, AnEventThatFindsNoRoomIsCounted) {
  Core1Writer core1{*memory};
  constexpr std::uint32_t kRoom = Core1Events::kCapacity;
  for (std::uint32_t i = 0; i < kRoom; ++i) core1.on_event(IoDone{.tag = i});
  EXPECT_EQ(host.lost_events(), 0u);
  core1.on_event(IoDone{.tag = kRoom});
  core1.on_event(IoDone{.tag = kRoom + 1});
  EXPECT_EQ(host.lost_events(), 2u);
  for (std::uint32_t i = 0; i < kRoom; ++i) {
    const std::optional<Event> event = host.next_event();
    ASSERT_TRUE(event);
    EXPECT_EQ(std::get<IoDone>(*event).tag, i);
  }
  EXPECT_FALSE(host.next_event());
}

TEST_F(HostMemoryTest, ARingGoesOnWhenItsCountersWrap) {
  memory->core1_events.written = memory->core1_events.read = 0xFFFF'FFF0;
  Core1Writer core1{*memory};
  for (std::uint32_t i = 0; i < 200; ++i) {
    core1.on_event(IoDone{.tag = i});
    EXPECT_EQ(std::get<IoDone>(host.next_event().value()).tag, i);
  }
  EXPECT_EQ(host.lost_events(), 0u);
}

TEST_F(HostMemoryTest, CommandsStayInTheirRingWhileTheInboxIsFull) {
  Inboxes inboxes;
  for (std::uint32_t i = 0; i < 16; ++i) ASSERT_TRUE(host.submit(Source::kScenario, ClearFault{i}));
  receive_commands(*memory, inboxes);
  EXPECT_TRUE(inbox_of(inboxes, Source::kScenario).full());
  ASSERT_TRUE(host.submit(Source::kScenario, ClearFault{16}));
  receive_commands(*memory, inboxes);
  for (std::uint32_t i = 0; i < 17; ++i) {
    const std::optional<Command> command = inbox_of(inboxes, Source::kScenario).try_pop();
    ASSERT_TRUE(command);
    EXPECT_EQ(std::get<ClearFault>(*command).tag, i);
    receive_commands(*memory, inboxes);
  }
}

// ---- LAYOUT.md

// Of a long list the first two elements are enough.
bool is_shown(const std::string& member) {
  for (std::size_t at = member.find('['); at != std::string::npos; at = member.find('[', at + 1)) {
    if (std::stoi(member.substr(at + 1)) > 1) return false;
  }
  return true;
}

template <class T>
void describe_type(std::ostream& out, std::string_view name, const std::string& about) {
  out << "\n## " << name << ", " << kWireSize<T> << " bytes" << about << "\n\n"
      << "| offset | type | member | values |\n|---:|---|---|---|\n";
  for (const auto& [field, member] : fields_of<T>()) {
    if (!is_shown(member)) continue;
    out << "| " << field.offset << " | " << field.type;
    if (field.count > 1) out << " x " << field.count;
    out << " | `" << member << "` |";
    for (std::size_t i = 0; i < field.words.size(); ++i) out << (i == 0 ? " " : ", ") << i << " " << field.words[i];
    out << " |\n";
  }
}

template <class... Messages>
void describe_kinds(std::ostream& out, std::type_identity<std::variant<Messages...>>) {
  int kind = 0;
  ((describe_type<Messages>(out, type_name_of<Messages>(), ", kind " + std::to_string(++kind))), ...);
}

std::string layout() {
  std::ostringstream out;
  out << "# Layout of the host memory\n\n"
      << "Written by `tests/controller/host_memory/host_memory_test.cpp`: `ARMATURE_WRITE_LAYOUT=FILE` writes a new "
         "one.\n\n"
      << "Numbers are little-endian: `u8` to `u64` unsigned, `i8` to `i64` signed, `f64` IEEE 754 binary64; a `flag` "
         "is\n"
      << "0 or 1. Matrices are written row by row. Of a list of structs the first two are shown; the others follow at "
         "the\n"
      << "same distance. A ring is `u32 written, read, lost, reserved` and its slots; number n is in slot n modulo "
         "their\n"
      << "count. A slot is `u32 kind, reserved` and the bytes of the message, padded with 0. The headers of the "
         "messages\n"
      << "say what the members mean.\n\n"
      << "## HostMemory, " << sizeof(HostMemory) << " bytes\n\n| offset | bytes | member |\n|---:|---:|---|\n";
  const auto memory = std::make_unique<HostMemory>();
  for_each_member(*memory, [&](const char* name, const auto& member) {
    const auto address = [](const void* object) { return static_cast<const std::byte*>(object); };
    const auto offset = address(&member) - address(memory.get());
    out << "| " << offset << " | " << sizeof(member) << " | `" << name << "` |\n";
  });
  out << "\n`commands`: " << kHostSources << " rings of " << CommandRing::kCapacity << " slots with "
      << CommandSlot::kSize << " bytes. `core0_events`, `core1_events`: " << Core0Events::kCapacity << " and "
      << Core1Events::kCapacity << " slots\nwith " << EventSlot::kSize << " bytes. `telemetry`: `u32 published, "
      << "reserved`, then Telemetry. `boot`: `u32 problem, place`, then the text.\n"
      << "`robot`, `config`, `program`: the last three tables. `layout`: 0x" << std::hex << layout_of_memory()
      << std::dec << ".\n`problem`:";
  for (std::size_t i = 0; i < kWordsOf<BootProblem>.size(); ++i) {
    out << (i == 0 ? " " : ", ") << i << ' ' << kWordsOf<BootProblem>[i];
  }
  out << ".\n";
  describe_kinds(out, std::type_identity<Command>{});
  describe_kinds(out, std::type_identity<Event>{});
  describe_type<Telemetry>(out, "Telemetry", "");
  describe_type<RobotModel>(out, "RobotModel", ", block robot");
  describe_type<ControllerConfig>(out, "ControllerConfig", ", block config");
  describe_type<ProgramFiles>(out, "ProgramFiles", ", block program");
  return out.str();
}

TEST(HostMemory, TheCommittedLayoutIsThatOfTheMessages) {
  if (const char* file = std::getenv("ARMATURE_WRITE_LAYOUT")) std::ofstream{file} << layout();
  std::ifstream file{std::string{ARMATURE_SOURCE_DIR} + "/controller/host_memory/LAYOUT.md"};
  const std::string committed{std::istreambuf_iterator<char>{file}, {}};
  EXPECT_EQ(committed, layout());
}

}  // namespace
}  // namespace armature::host_memory
