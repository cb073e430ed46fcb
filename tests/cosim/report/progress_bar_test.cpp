// The progress of a run on a terminal.
#include "cosim/report/format/progress_bar.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <sstream>

namespace armature::cosim {
namespace {

using testing::EndsWith;
using testing::StartsWith;

TEST(ProgressBar, ShowsTimeFactorAndTimeLeft) {
  EXPECT_EQ(progress_line(0.5, 1.0, 2.0), "[###############---------------]  50 %  0.500 of 1.000 s  x0.250  2 s left");
  EXPECT_EQ(progress_line(0, 1, 0), "[------------------------------]   0 %  0.000 of 1.000 s");
  EXPECT_THAT(progress_line(1.0, 100.0, 60.0), EndsWith("x0.017  1 h 39 min left"));
  EXPECT_THAT(progress_line(1.0, 10.0, 10.0), EndsWith("x0.100  1 min 30 s left"));
  EXPECT_THAT(progress_line(2.0, 1.0, 1.0), StartsWith("[##############################] 100 %"));
}

TEST(ProgressBar, RedrawsAtMostTenTimesASecondAndCleansUp) {
  std::ostringstream out;
  ProgressBar::Clock::time_point now{};
  {
    ProgressBar bar{out, 1.0, true, [&] { return now; }};
    for (int ms = 0; ms < 1000; ++ms) {
      now = ProgressBar::Clock::time_point{std::chrono::milliseconds{ms}};
      bar.update(ms / 1000.0);
    }
  }
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 9 + 1);
  EXPECT_THAT(text, EndsWith("\r\033[K"));
}

TEST(ProgressBar, IsSilentWhenNotEnabled) {
  std::ostringstream out;
  ProgressBar::Clock::time_point now{};
  {
    ProgressBar bar{out, 1.0, false, [&] { return now; }};
    now += std::chrono::seconds{5};
    bar.update(0.5);
  }
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace armature::cosim
