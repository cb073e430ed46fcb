#include "cosim/snapshot/return_points.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "cosim/snapshot/copied_process.hpp"
#include "cosim/snapshot/message_channel.hpp"
#include "tests/cosim/snapshot/processes.hpp"

namespace armature::cosim {
namespace {

struct Order {
  enum class What : std::uint8_t { kMark, kGoBack, kRemember };
  What what = What::kMark;
  std::int64_t value = 0;  // a key, or what to remember
};

struct Answer {
  bool back = false;  // of kMark
  std::int64_t remembered = 0;
  std::size_t points = 0;
  bool can_go_back_to_five = false;
  pid_t process = 0;
};

[[noreturn]] void obey(MessageChannel& channel) {
  ReturnPoints points{channel.descriptor()};
  std::int64_t remembered = 0;
  while (const std::optional<Order> order = channel.receive<Order>()) {
    bool back = false;
    if (order->what == Order::What::kMark) back = points.mark(order->value);
    if (order->what == Order::What::kGoBack) points.go_back(order->value);
    if (order->what == Order::What::kRemember) remembered = order->value;
    channel.send(Answer{.back = back,
                        .remembered = remembered,
                        .points = points.count(),
                        .can_go_back_to_five = points.can_go_back(5),
                        .process = ::getpid()});
  }
  ::_exit(0);
}

// A process that remembers a number, and goes back to earlier ones.
class Forgetful {
 public:
  Forgetful() {
    auto [ours, theirs] = MessageChannel::pair();
    process_ = copy_this_process(theirs.descriptor());
    if (process_ == 0) obey(theirs);
    channel_ = std::move(ours);
  }
  Forgetful(const Forgetful&) = delete;
  Forgetful& operator=(const Forgetful&) = delete;
  ~Forgetful() { end(); }

  void end() {
    channel_.close();
    if (process_ != 0) wait_for_end(std::exchange(process_, 0));
  }

  std::optional<Answer> ask(Order::What what, std::int64_t value) {
    channel_.send(Order{what, value});
    return channel_.receive<Answer>();
  }
  Answer remember(std::int64_t value) { return ask(Order::What::kRemember, value).value(); }
  Answer mark(std::int64_t key) { return ask(Order::What::kMark, key).value(); }
  // The answer of the mark where it continues.
  Answer go_back(std::int64_t key) { return ask(Order::What::kGoBack, key).value(); }

 private:
  MessageChannel channel_;
  pid_t process_ = 0;
};

TEST(ReturnPoints, KnowHowFarBackTheyReach) {
  Forgetful process;
  EXPECT_FALSE(process.remember(1).can_go_back_to_five) << "without a point";
  EXPECT_FALSE(process.mark(6).can_go_back_to_five);
  EXPECT_FALSE(process.mark(7).can_go_back_to_five);
  EXPECT_FALSE(process.go_back(6).can_go_back_to_five);
  Forgetful other;
  EXPECT_TRUE(other.mark(5).can_go_back_to_five);
  EXPECT_TRUE(other.mark(6).can_go_back_to_five);
}

TEST(ReturnPoints, GoBackWithTheMemoryOfThePoint) {
  Forgetful process;
  process.remember(5);
  EXPECT_FALSE(process.mark(10).back);
  EXPECT_EQ(process.remember(6).remembered, 6);
  const Answer answer = process.go_back(10);
  EXPECT_TRUE(answer.back);
  EXPECT_EQ(answer.remembered, 5);
}

TEST(ReturnPoints, GoBackToTheLatestOneThatIsNotAboveTheKey) {
  Forgetful process;
  for (const std::int64_t key : {10, 20, 30, 40}) {
    process.remember(key);
    process.mark(key);
  }
  EXPECT_EQ(process.go_back(39).remembered, 30);
  EXPECT_EQ(process.go_back(39).remembered, 30) << "as often as one likes";
  EXPECT_EQ(process.go_back(20).remembered, 20);
  EXPECT_EQ(process.go_back(40).remembered, 20) << "the later ones are gone";
  EXPECT_EQ(process.go_back(10).remembered, 10);
  process.remember(7);
  EXPECT_EQ(process.mark(15).points, 2u);
  process.remember(8);
  EXPECT_EQ(process.go_back(15).remembered, 7);
  EXPECT_EQ(process.go_back(14).points, 1u);
}

TEST(ReturnPoints, BeforeTheFirstOneThereIsNothing) {
  Forgetful process;
  process.mark(10);
  EXPECT_FALSE(process.ask(Order::What::kGoBack, 9));
}

TEST(ReturnPoints, LeaveNoProcess) {
  Forgetful process;
  std::vector<pid_t> all;
  for (std::int64_t key = 0; key < 5; ++key) all.push_back(process.mark(key).process);
  all.push_back(process.go_back(2).process);
  EXPECT_TRUE(test::has_ended(all[3]));
  EXPECT_TRUE(test::has_ended(all[4]));
  process.end();
  for (const pid_t one : all) EXPECT_TRUE(test::has_ended(one)) << one;
}

}  // namespace
}  // namespace armature::cosim
