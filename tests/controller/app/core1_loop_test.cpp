#include "controller/app/core1_loop.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "controller/base/overloaded.hpp"

namespace armature {
namespace {

std::string name_of(const Event& event) {
  return std::visit(Overloaded{
                        [](const MoveStarted& move) { return "started " + std::to_string(move.tag.number()); },
                        [](const MoveFinished& move) { return "finished " + std::to_string(move.tag.number()); },
                        [](const MoveRefused& move) { return "refused " + std::to_string(move.tag.number()); },
                        [](const auto&) { return std::string{"other"}; },
                    },
                    event);
}

class Listener final : public EventListener {
 public:
  void on_event(const Event& event) noexcept override { events.push_back(name_of(event)); }
  std::vector<std::string> events;
};

// Answers each wait with the next of `wakes`, then ends the main.
class Bus final : public RegisterBus {
 public:
  explicit Bus(std::vector<Interrupts> wakes) : wakes_{std::move(wakes)} {}
  std::uint32_t read32(RegAddr) noexcept override { return 0; }
  void write32(RegAddr, std::uint32_t) noexcept override {}
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override {
    masks.push_back(mask);
    return masks.size() <= wakes_.size() ? wakes_[masks.size() - 1] : Interrupts::kNone;
  }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return {}; }
  void charge(Work, std::int64_t) noexcept override {}
  std::vector<Interrupts> masks;

 private:
  std::vector<Interrupts> wakes_;
};

// Has `steps` to do; each notes its name in `journal` and causes the refusal of a command with that number.
class Client final : public Core1Client {
 public:
  Client(std::string name, std::vector<std::string>& journal) : name_{std::move(name)}, journal_{journal} {}
  bool execute(RegisterBus&) noexcept override {
    if (steps == 0) return false;
    journal_.push_back(name_);
    if (reports_to != nullptr) reports_to->on_event(MoveRefused{.tag = static_cast<std::uint32_t>(steps)});
    return --steps > 0;
  }
  bool waits_for_time() const noexcept override { return timed; }
  void on_event(const Event& event) noexcept override { events.push_back(name_of(event)); }

  int steps = 0;
  bool timed = false;
  EventListener* reports_to = nullptr;
  std::vector<std::string> events;

 private:
  std::string name_;
  std::vector<std::string>& journal_;
};

class Handler final : public InterruptHandler {
 public:
  bool enabled() const noexcept override { return is_enabled; }
  void on_interrupt(RegisterBus&) noexcept override { ++interrupts; }
  bool is_enabled = true;
  int interrupts = 0;
};

struct Core1LoopTest : testing::Test {
  Core1LoopTest() {
    loop.add(first);
    loop.add(second);
    loop.add(Interrupts::kGpio, gpio);
    loop.add(Interrupts::kUart, uart);
  }
  Channel channel;
  Listener host;
  Core1Loop loop{channel, host};
  std::vector<std::string> journal;
  Client first{"first", journal}, second{"second", journal};
  Handler gpio, uart;
};

TEST_F(Core1LoopTest, ClientsHaveTurnsUntilNoneHasMoreToDo) {
  first.steps = 3;
  second.steps = 2;
  Bus bus{{Interrupts::kEvent}};
  loop.run(bus);
  EXPECT_EQ(journal, (std::vector<std::string>{"first", "second", "first", "second", "first"}));
}

TEST_F(Core1LoopTest, AnInterruptGoesToItsHandlerAlone) {
  Bus bus{{Interrupts::kUart, Interrupts::kEvent, Interrupts::kUart | Interrupts::kGpio}};
  loop.run(bus);
  EXPECT_EQ(gpio.interrupts, 1);
  EXPECT_EQ(uart.interrupts, 2);
}

TEST_F(Core1LoopTest, OnlyEnabledLinesWakeTheCore) {
  gpio.is_enabled = false;
  Bus bus{{}};
  loop.run(bus);
  gpio.is_enabled = true;
  uart.is_enabled = false;
  loop.run(bus);
  EXPECT_EQ(bus.masks,
            (std::vector<Interrupts>{Interrupts::kEvent | Interrupts::kUart, Interrupts::kEvent | Interrupts::kGpio}));
}

TEST_F(Core1LoopTest, ClientsAreNotifiedOfTheEventsOfBothCoresAndTheHostOfThoseOfCore1) {
  ASSERT_TRUE(channel.events.try_push(MoveStarted{.tag = 7}));
  ASSERT_TRUE(channel.events.try_push(MoveFinished{.tag = 7}));
  first.steps = 1;
  first.reports_to = &loop;
  Bus bus{{Interrupts::kEvent}};
  loop.run(bus);
  const std::vector<std::string> all{"started 7", "finished 7", "refused 1"};
  EXPECT_EQ(first.events, all);
  EXPECT_EQ(second.events, all);
  EXPECT_EQ(host.events, (std::vector<std::string>{"refused 1"}));
}

TEST_F(Core1LoopTest, Core0WakesItInEachTickWhileAClientWaitsForTime) {
  second.timed = true;
  Bus bus{{Interrupts::kEvent}};
  loop.run(bus);
  EXPECT_TRUE(channel.loop.wake_each_tick.load());
  second.timed = false;
  Bus again{{Interrupts::kEvent}};
  loop.run(again);
  EXPECT_FALSE(channel.loop.wake_each_tick.load());
}

TEST(Tag, HoldsASourceAndANumberIn32Bits) {
  const Tag tag{Source::kScenario, 0x00AB'CDEF};
  EXPECT_EQ(tag.source(), Source::kScenario);
  EXPECT_EQ(tag.number(), 0x00AB'CDEFu);
  const Tag other = Tag::from_word(0x0500'0007);
  EXPECT_EQ(static_cast<int>(other.source()), 5);
  EXPECT_EQ(other.number(), 7u);
  EXPECT_EQ(other.word(), 0x0500'0007u);
  EXPECT_NE(other, Tag{7});
}

}  // namespace
}  // namespace armature
