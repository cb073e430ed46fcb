#include "cosim/snapshot/waiting_copy.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "cosim/snapshot/copied_process.hpp"
#include "tests/cosim/snapshot/processes.hpp"
#include "tests/cosim/snapshot/refused_copies.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::read_file;
using test::TempFolder;

// A snapshot whose copy gives `answer(order)`.
template <class Answer>
WaitingCopy snapshot_that(Answer answer) {
  auto taken = take_snapshot();
  if (auto* woken = std::get_if<WokenCopy>(&taken)) woken->end(answer(woken->order<int>()));
  return std::get<WaitingCopy>(std::move(taken));
}

bool has_no_child() {
  return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}

TEST(WaitingCopy, GoesOnFromTheTimeOfTheSnapshot) {
  std::vector<int> memory{1, 2, 3};
  WaitingCopy snapshot = snapshot_that([&](int order) { return order + memory.back(); });
  memory.assign(1'000, 7);
  ASSERT_TRUE(snapshot.wake(100));
  EXPECT_EQ(snapshot.answer<int>(), 103);
}

TEST(WaitingCopy, EachOfSeveralAnswersForItself) {
  std::vector<WaitingCopy> snapshots;
  int time = 0;
  for (; time < 4; ++time) snapshots.push_back(snapshot_that([&](int order) { return 10 * order + time; }));
  for (const int which : {2, 0, 3}) {
    ASSERT_TRUE(snapshots.at(static_cast<std::size_t>(which)).wake(5));
    EXPECT_EQ(snapshots.at(static_cast<std::size_t>(which)).answer<int>(), 50 + which);
  }
}

TEST(WaitingCopy, SaysWhatTheHostLacksForACopy) {
  const auto take = [] {
    test::refuse_copies();
    try {
      (void)take_snapshot();
    } catch (const std::runtime_error& error) {
      std::fputs(error.what(), stderr);
      ::_exit(0);
    }
    ::_exit(1);
  };
  EXPECT_EXIT(take(), testing::ExitedWithCode(0),
              "cannot copy this process: .*; it needs more processes \\(ulimit -u\\)");
}

TEST(WaitingCopy, LeavesNoProcess) {
  std::vector<pid_t> processes;
  {
    std::vector<WaitingCopy> snapshots;
    for (int i = 0; i < 3; ++i) snapshots.push_back(snapshot_that([](int order) { return order; }));
    for (const WaitingCopy& snapshot : snapshots) processes.push_back(snapshot.process());
    for (const pid_t process : processes) EXPECT_FALSE(test::has_ended(process));
    snapshots.front().wake(1);
    EXPECT_EQ(snapshots.front().answer<int>(), 1);
  }
  EXPECT_TRUE(has_no_child());
  for (const pid_t process : processes) EXPECT_EQ(::kill(process, 0), -1) << process;
}

TEST(WaitingCopy, WritesNothingIntoTheFilesOfTheOriginal) {
  const TempFolder folder;
  const auto file = folder.path() / "out.txt";
  std::FILE* const out = std::fopen(file.c_str(), "w");
  std::fputs("before ", out);  // still in the buffer
  WaitingCopy snapshot = snapshot_that([&](int) { return std::fputs("copy ", out) >= 0 && std::fflush(out) == 0; });
  std::fputs("after ", out);
  ASSERT_TRUE(snapshot.wake(0));
  EXPECT_EQ(snapshot.answer<bool>(), true);
  std::fputs("end", out);
  std::fclose(out);
  EXPECT_EQ(read_file(file), "before after end");
}

TEST(WaitingCopy, CanWriteFilesOfItsOwn) {
  const TempFolder folder;
  const auto file = folder.path() / "own.txt";
  WaitingCopy snapshot = snapshot_that([&](int order) {
    std::ofstream{file} << order;
    return 0;
  });
  snapshot.wake(42);
  ASSERT_TRUE(snapshot.answer<int>());
  EXPECT_EQ(read_file(file), "42");
}

TEST(WaitingCopy, ReadsOnWhereTheOriginalWas) {
  const TempFolder folder;
  const FileDescriptor in{::open(folder.write("in.txt", "abcdefghi").c_str(), O_RDONLY)};
  const auto next_three = [&] {
    std::array<char, 4> text{};
    EXPECT_EQ(::read(in.get(), text.data(), 3), 3);
    return text;
  };
  EXPECT_STREQ(next_three().data(), "abc");
  WaitingCopy snapshot = snapshot_that([&](int) { return next_three(); });
  EXPECT_STREQ(next_three().data(), "def");
  snapshot.wake(0);
  const auto read = snapshot.answer<std::array<char, 4>>();
  ASSERT_TRUE(read);
  EXPECT_STREQ(read->data(), "def");
  EXPECT_STREQ(next_three().data(), "ghi");
}

// Who waits for the end of a pipe of this process must see it.
TEST(WaitingCopy, HoldsNoOtherEndOfAPipe) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const FileDescriptor read_end{ends[0]};
  FileDescriptor write_end{ends[1]};
  const WaitingCopy snapshot = snapshot_that([](int order) { return order; });
  write_end.close();
  char byte = 0;
  EXPECT_EQ(::read(read_end.get(), &byte, 1), 0);
}

TEST(WaitingCopy, ACopyThatFailsGivesNoAnswer) {
  WaitingCopy snapshot = snapshot_that([](int) -> int { ::_exit(1); });
  snapshot.wake(0);
  EXPECT_FALSE(snapshot.answer<int>());
}

// However the original ends: waiting copies and those that work end, too.
TEST(WaitingCopy, EndsWithItsOriginal) {
  auto [ours, of_original] = MessageChannel::pair();
  const pid_t original = copy_this_process(of_original.descriptor());
  if (original == 0) {
    const WaitingCopy waiting = snapshot_that([](int order) { return order; });
    WaitingCopy working = snapshot_that([](int) -> int {
      while (true) ::pause();
    });
    working.wake(0);
    of_original.send(std::array{waiting.process(), working.process()});
    while (true) ::pause();
  }
  const auto copies = ours.receive<std::array<pid_t, 2>>();
  ASSERT_TRUE(copies);
  for (const pid_t copy : *copies) EXPECT_FALSE(test::has_ended(copy));
  ASSERT_EQ(::kill(original, SIGKILL), 0);
  wait_for_end(original);
  for (const pid_t copy : *copies) EXPECT_TRUE(test::ends(copy)) << copy;
}

TEST(WaitingCopy, IsNotTakenOfAProcessWithThreads) {
  std::mutex held;
  held.lock();
  std::thread other{[&] { const std::scoped_lock wait{held}; }};
  EXPECT_THROW((void)take_snapshot(), std::runtime_error);
  held.unlock();
  other.join();
  EXPECT_TRUE(has_no_child());
}

}  // namespace
}  // namespace armature::cosim
