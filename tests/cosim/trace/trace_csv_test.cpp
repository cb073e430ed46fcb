#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "cosim/text/sha256.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "tests/cosim/support/counted_row.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::read_file;
using test::TempFolder;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

TraceRow row_at(std::int64_t tick) {
  TraceRow row = test::counted_row(tick);
  for (std::size_t i = 0; i < kAxes; ++i) {
    const auto n = static_cast<std::int64_t>(i + 1);
    row.telemetry.reference[i] = Radians{static_cast<double>(n) * 1.5 * kRadPerDeg};
    row.telemetry.actual[i] = Radians{static_cast<double>(-n) * kRadPerDeg};
  }
  return row;
}

std::string text_of(const TraceRow& row, char* (*append)(char*, const TraceRow&)) {
  std::string text(kMaxRowText, '\0');
  text.resize(static_cast<std::size_t>(append(text.data(), row) - text.data()));
  return text;
}

// The last value of every line but the header.
std::vector<std::string> digests_of(const std::string& csv) {
  std::vector<std::string> digests;
  std::istringstream lines{csv};
  std::string line;
  std::getline(lines, line);
  EXPECT_THAT(line, testing::EndsWith(",digest2"));
  while (std::getline(lines, line)) digests.push_back(line.substr(line.rfind(',') + 1));
  return digests;
}

// A trace of ticks 0.. as a run writes it.
std::string trace_of(std::int64_t ticks, std::int64_t every_ticks) {
  const TempFolder folder;
  CsvWriter writer{folder.path() / "trace.csv", every_ticks};
  IntegerDigest digest;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    digest.add(row_at(tick));
    writer.write(row_at(tick), digest);
  }
  writer.close();
  return read_file(folder.path() / "trace.csv");
}

TEST(TraceColumns, AreNamedWithTheirUnits) {
  EXPECT_EQ(integer_header(),
            "state,"
            "j1_cmd_pulses,j2_cmd_pulses,j3_cmd_pulses,j4_cmd_pulses,j5_cmd_pulses,j6_cmd_pulses,"
            "j1_pin_pulses,j2_pin_pulses,j3_pin_pulses,j4_pin_pulses,j5_pin_pulses,j6_pin_pulses,"
            "j1_enc_counts,j2_enc_counts,j3_enc_counts,j4_enc_counts,j5_enc_counts,j6_enc_counts,"
            "j1_corr_pulses,j2_corr_pulses,j3_corr_pulses,j4_corr_pulses,j5_corr_pulses,j6_corr_pulses");
  EXPECT_EQ(float_header(),
            "j1_ref_deg,j2_ref_deg,j3_ref_deg,j4_ref_deg,j5_ref_deg,j6_ref_deg,"
            "j1_enc_deg,j2_enc_deg,j3_enc_deg,j4_enc_deg,j5_enc_deg,j6_enc_deg");
  EXPECT_EQ(trace_header(ToolColumns::kNo), "tick,time_s," + integer_header() + "," + float_header() + ",digest2");
  EXPECT_EQ(trace_header(ToolColumns::kYes),
            "tick,time_s," + integer_header() + "," + float_header() + "," + tool_point_header() + ",digest2");
}

TEST(TraceColumns, GiveTheTimeOfTheTriggerExactlyAndTheStateAsAWord) {
  const auto row_text = [](const TraceRow& row) {
    std::string text(kMaxRowText, '\0');
    text.resize(
        static_cast<std::size_t>(append_row(text.data(), row, "0123456789abcdef", ToolColumns::kNo) - text.data()));
    return text;
  };
  TraceRow row = row_at(1);
  row.cycle = 3108 + 2500;
  EXPECT_THAT(row_text(row), testing::StartsWith("1,0.00011216,moving,1,2,"));
  EXPECT_THAT(row_text(row), testing::EndsWith(",-6.000000,0123456789abcdef"));
  row.cycle = 86'400LL * 50'000'000 - 1;  // of the longest run
  row.telemetry.state = MotionState::kFault;
  EXPECT_THAT(row_text(row), testing::StartsWith("1,86399.99999998,fault,"));
}

TEST(TraceColumns, WriteIntegersExactlySetPointsWithNineDigitsAndMeasuredAnglesWithSix) {
  TraceRow row = row_at(100);
  EXPECT_EQ(text_of(row, append_integers),
            "moving,100,200,300,400,500,600,99,199,299,399,499,599,-100,-200,-300,-400,-500,-600,1,2,3,4,5,6");
  EXPECT_EQ(text_of(row, append_floats),
            "1.500000000,3.000000000,4.500000000,6.000000000,7.500000000,9.000000000,"
            "-1.000000,-2.000000,-3.000000,-4.000000,-5.000000,-6.000000");

  for (std::size_t i = 0; i < kAxes; ++i) {
    row.telemetry.commanded[i] = Pulses{std::numeric_limits<std::int64_t>::min()};
    row.pin_pulses[i] = std::numeric_limits<std::int64_t>::min();
    row.telemetry.encoder[i] = Counts{std::numeric_limits<std::int64_t>::min()};
    row.telemetry.correction[i] = Pulses{std::numeric_limits<std::int64_t>::min()};
  }
  EXPECT_THAT(text_of(row, append_integers), testing::StartsWith("moving,-9223372036854775808,"));
}

TEST(TraceColumns, NeverWriteMinusZeroNorUnboundedText) {
  TraceRow row;
  row.telemetry.reference = {Radians{-0.0},
                             Radians{-1e-13},
                             Radians{-1e-8},
                             Radians{1e300},
                             Radians{-1e14 * kRadPerDeg},
                             Radians{std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THAT(text_of(row, append_floats),
              testing::StartsWith("0.000000000,0.000000000,-0.000000573,nan,-100000000000000.000000000,nan,0.000000,"));
}

TEST(TraceColumns, GiveTheToolPointOfSetPointAndEncoders) {
  EXPECT_EQ(tool_point_header(), "tcp_ref_x_mm,tcp_ref_y_mm,tcp_ref_z_mm,tcp_enc_x_mm,tcp_enc_y_mm,tcp_enc_z_mm");
  TraceRow row;
  row.tool_point = ToolPoint{.reference_mm = {1.5, -2, -1e-9}, .encoder_mm = {4, 5.0000006, -6000}};
  EXPECT_EQ(text_of(row, append_tool_point), "1.500000000,-2.000000000,-0.000000001,4.000000,5.000001,-6000.000000");
  row.tool_point.reset();
  EXPECT_EQ(text_of(row, append_tool_point), "nan,nan,nan,nan,nan,nan");
}

TEST(CsvWriter, WritesTheToolPointOnlyWhenAsked) {
  const TempFolder folder;
  TraceRow row = row_at(0);
  row.tool_point = ToolPoint{.reference_mm = {1, 2, 3}, .encoder_mm = {4, 5, 6}};
  for (const ToolColumns columns : {ToolColumns::kNo, ToolColumns::kYes}) {
    CsvWriter writer{folder.path() / "trace.csv", 20, columns};
    IntegerDigest digest;
    digest.add(row);
    writer.write(row, digest);
    writer.close();
    const std::string text = read_file(folder.path() / "trace.csv");
    const std::string end = "," + digest.hex().substr(0, 16) + "\n";
    EXPECT_THAT(text, testing::StartsWith(trace_header(columns) + "\n0,0.00000000,moving,"));
    if (columns == ToolColumns::kYes) {
      EXPECT_THAT(text,
                  testing::EndsWith("-6.000000,1.000000000,2.000000000,3.000000000,4.000000,5.000000,6.000000" + end));
    } else {
      EXPECT_THAT(text, testing::EndsWith("-6.000000" + end));
    }
  }
}

TEST(CsvWriter, WritesEveryNthTick) {
  const TempFolder folder;
  const auto file = folder.path() / "new/trace.csv";
  CsvWriter writer{file, 20};
  IntegerDigest digest;
  for (std::int64_t tick = 0; tick <= 100; ++tick) {
    digest.add(row_at(tick));
    writer.write(row_at(tick), digest);
  }
  EXPECT_EQ(writer.rows(), 6);
  writer.close();
  const std::string text = read_file(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
  EXPECT_THAT(text, testing::StartsWith(trace_header(ToolColumns::kNo) + "\n0,"));
  EXPECT_THAT(text, testing::HasSubstr("\n20,0.00000000,moving,20,40,"));
}

TEST(CsvWriter, GivesARowTheSameDigestAtAnyRate) {
  constexpr std::int64_t kTicks = 500;
  const std::vector<std::string> digests = digests_of(trace_of(kTicks, 1));
  ASSERT_EQ(std::ssize(digests), kTicks);
  for (const std::int64_t every : {7, 20, 499}) {
    const std::vector<std::string> fewer = digests_of(trace_of(kTicks, every));
    for (std::size_t i = 0; i < fewer.size(); ++i) {
      EXPECT_EQ(fewer[i], digests[i * static_cast<std::size_t>(every)]) << every << " " << i;
    }
  }
}

TEST(CsvWriter, LeavesWholeLinesWhenItIsNotClosed) {
  const TempFolder folder;
  const auto file = folder.path() / "trace.csv";
  {
    CsvWriter writer{file, 1};
    IntegerDigest digest;
    for (std::int64_t tick = 0; tick < 5000; ++tick) {
      digest.add(row_at(tick));
      writer.write(row_at(tick), digest);
    }
  }
  const std::string text = read_file(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5001);
  EXPECT_TRUE(text.ends_with('\n'));
}

TEST(CsvWriter, NamesTheFileThatCannotBeWritten) {
  const TempFolder folder;
  try {
    CsvWriter writer{folder.path(), 1};
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string{error.what()}, folder.path().string() + ": cannot write: Is a directory");
  }
  EXPECT_THROW((CsvWriter{"/dev/full", 1}.close()), std::runtime_error);
}

TEST(Sha256, KnowsThePublishedVectors) {
  Sha256 hash;
  EXPECT_EQ(hash.hex(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  hash.add("a");
  (void)hash.hex();  // must not end the stream
  hash.add("bc");
  EXPECT_EQ(hash.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace armature::cosim
