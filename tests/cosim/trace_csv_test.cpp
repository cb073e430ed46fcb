#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "cosim/text/sha256.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::read_file;
using test::TempFolder;

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

TraceRow row_at(std::int64_t tick) {
  TraceRow row;
  row.tick = tick;
  row.telemetry.state = MotionState::kMoving;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const auto n = static_cast<std::int64_t>(i + 1);
    row.telemetry.commanded[i] = Pulses{tick * n};
    row.pin_pulses[i] = tick * n - 1;
    row.telemetry.encoder[i] = Counts{-tick * n};
    row.telemetry.correction[i] = Pulses{n};
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

// The first 26 fields of every line: `cut -d, -f1-26`.
std::string cut_integers(const std::string& csv) {
  std::string cut;
  int commas = 0;
  for (const char c : csv) {
    if (c == '\n') commas = 0;
    if (c == ',') ++commas;
    if (commas < 26) cut += c;
  }
  return cut;
}

TEST(TraceColumns, AreNamedWithTheirUnits) {
  EXPECT_EQ(integer_header(),
            "tick,state,"
            "j1_cmd_pulses,j2_cmd_pulses,j3_cmd_pulses,j4_cmd_pulses,j5_cmd_pulses,j6_cmd_pulses,"
            "j1_pin_pulses,j2_pin_pulses,j3_pin_pulses,j4_pin_pulses,j5_pin_pulses,j6_pin_pulses,"
            "j1_enc_counts,j2_enc_counts,j3_enc_counts,j4_enc_counts,j5_enc_counts,j6_enc_counts,"
            "j1_corr_pulses,j2_corr_pulses,j3_corr_pulses,j4_corr_pulses,j5_corr_pulses,j6_corr_pulses");
  EXPECT_EQ(float_header(),
            "j1_ref_deg,j2_ref_deg,j3_ref_deg,j4_ref_deg,j5_ref_deg,j6_ref_deg,"
            "j1_enc_deg,j2_enc_deg,j3_enc_deg,j4_enc_deg,j5_enc_deg,j6_enc_deg");
}

TEST(TraceColumns, WriteIntegersExactlyAndAnglesWithSixDigits) {
  TraceRow row = row_at(100);
  EXPECT_EQ(text_of(row, append_integers),
            "100,1,100,200,300,400,500,600,99,199,299,399,499,599,-100,-200,-300,-400,-500,-600,1,2,3,4,5,6");
  EXPECT_EQ(text_of(row, append_floats),
            "1.500000,3.000000,4.500000,6.000000,7.500000,9.000000,"
            "-1.000000,-2.000000,-3.000000,-4.000000,-5.000000,-6.000000");

  row.tick = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < kAxes; ++i) {
    row.telemetry.commanded[i] = Pulses{std::numeric_limits<std::int64_t>::min()};
    row.pin_pulses[i] = std::numeric_limits<std::int64_t>::min();
    row.telemetry.encoder[i] = Counts{std::numeric_limits<std::int64_t>::min()};
    row.telemetry.correction[i] = Pulses{std::numeric_limits<std::int64_t>::min()};
  }
  EXPECT_THAT(text_of(row, append_integers), testing::StartsWith("9223372036854775807,1,-9223372036854775808,"));
}

TEST(TraceColumns, NeverWriteMinusZeroNorUnboundedText) {
  TraceRow row;
  row.telemetry.reference = {Radians{-0.0},
                             Radians{-1e-12},
                             Radians{-1e-8},
                             Radians{1e300},
                             Radians{-1e14 * kRadPerDeg},
                             Radians{std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THAT(text_of(row, append_floats),
              testing::StartsWith("0.000000,0.000000,-0.000001,nan,-100000000000000.000000,nan,0.000000,"));
}

TEST(TraceColumns, GiveTheToolPointOfSetPointAndEncoders) {
  EXPECT_EQ(tool_point_header(), "tcp_ref_x_mm,tcp_ref_y_mm,tcp_ref_z_mm,tcp_enc_x_mm,tcp_enc_y_mm,tcp_enc_z_mm");
  TraceRow row;
  row.tool_point = ToolPoint{.reference_mm = {1.5, -2, -1e-9}, .encoder_mm = {4, 5.0000006, -6000}};
  EXPECT_EQ(text_of(row, append_tool_point), "1.500000,-2.000000,0.000000,4.000000,5.000001,-6000.000000");
  row.tool_point.reset();
  EXPECT_EQ(text_of(row, append_tool_point), "nan,nan,nan,nan,nan,nan");
}

TEST(CsvWriter, WritesTheToolPointOnlyWhenAsked) {
  const TempFolder folder;
  TraceRow row = row_at(0);
  row.tool_point = ToolPoint{.reference_mm = {1, 2, 3}, .encoder_mm = {4, 5, 6}};
  for (const ToolColumns columns : {ToolColumns::kNo, ToolColumns::kYes}) {
    CsvWriter writer{folder.path() / "trace.csv", 20, columns};
    writer.write(row);
    writer.close();
    const std::string text = read_file(folder.path() / "trace.csv");
    const std::string head = integer_header() + "," + float_header();
    if (columns == ToolColumns::kYes) {
      EXPECT_THAT(text, testing::StartsWith(head + "," + tool_point_header() + "\n0,1,"));
      EXPECT_THAT(text, testing::EndsWith("-6.000000,1.000000,2.000000,3.000000,4.000000,5.000000,6.000000\n"));
    } else {
      EXPECT_THAT(text, testing::StartsWith(head + "\n0,1,"));
      EXPECT_THAT(text, testing::EndsWith("-6.000000\n"));
    }
  }
}

TEST(CsvWriter, WritesEveryNthTick) {
  const TempFolder folder;
  const auto file = folder.path() / "new/trace.csv";
  CsvWriter writer{file, 20};
  for (std::int64_t tick = 0; tick <= 100; ++tick) writer.write(row_at(tick));
  EXPECT_EQ(writer.rows(), 6);
  writer.close();
  const std::string text = read_file(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
  EXPECT_THAT(text, testing::StartsWith(integer_header() + "," + float_header() + "\n0,1,"));
  EXPECT_THAT(text, testing::HasSubstr("\n20,1,20,40,"));
  EXPECT_THAT(text, testing::EndsWith("-6.000000\n"));
}

TEST(CsvWriter, LeavesWholeLinesWhenItIsNotClosed) {
  const TempFolder folder;
  const auto file = folder.path() / "trace.csv";
  {
    CsvWriter writer{file, 1};
    for (std::int64_t tick = 0; tick < 5000; ++tick) writer.write(row_at(tick));
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

TEST(IntegerDigest, IsThatOfTheCutFullRateTraceWhateverItsLength) {
  for (const std::int64_t ticks : {0, 1, 37, 5000}) {
    const TempFolder folder;
    const auto file = folder.path() / "trace.csv";
    CsvWriter writer{file, 1};
    IntegerDigest digest;
    for (std::int64_t tick = 0; tick < ticks; ++tick) {
      writer.write(row_at(tick));
      digest.add(row_at(tick));
    }
    writer.close();
    Sha256 expected;
    expected.add(cut_integers(read_file(file)));
    EXPECT_EQ(digest.hex(), expected.hex()) << ticks;
  }
}

TEST(IntegerDigest, SeesEveryIntegerColumnAndNoFloat) {
  const auto digest_of = [](const TraceRow& row) {
    IntegerDigest digest;
    digest.add(row);
    return digest.hex();
  };
  const TraceRow base = row_at(7);
  const std::string before = digest_of(base);
  TraceRow row = base;
  row.telemetry.reference[3] = Radians{2.0};
  row.telemetry.actual[3] = Radians{2.0};
  EXPECT_EQ(digest_of(row), before);
  row = base, row.tick += 1;
  EXPECT_NE(digest_of(row), before);
  row = base, row.telemetry.state = MotionState::kFault;
  EXPECT_NE(digest_of(row), before);
  for (std::size_t i = 0; i < kAxes; ++i) {
    row = base, row.telemetry.commanded[i] += Pulses{1};
    EXPECT_NE(digest_of(row), before);
    row = base, row.pin_pulses[i] += 1;
    EXPECT_NE(digest_of(row), before);
    row = base, row.telemetry.encoder[i] += Counts{1};
    EXPECT_NE(digest_of(row), before);
    row = base, row.telemetry.correction[i] += Pulses{1};
    EXPECT_NE(digest_of(row), before);
  }
}

}  // namespace
}  // namespace armature::cosim
