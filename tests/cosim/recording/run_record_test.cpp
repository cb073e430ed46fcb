#include "cosim/recording/run_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

using test::TempFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kSummary =
    R"({"scenario": "s", "description": "d", "result": {"final_joint_deg": [1, 2, 3, 4, 5], "moves": []}})";

TEST(RunRecord, HasTraceAndSummaryOfAFolder) {
  const TempFolder folder;
  (void)folder.write("trace.csv", "tick,a\n0,1\n");
  const auto summary = folder.write("summary.json", kSummary);
  const RunRecord run = read_run_record(summary.parent_path(), "trace.csv", "summary.json");
  EXPECT_EQ(run.axis_count(), 5U);
  EXPECT_EQ(run.trace.rows(), 1U);
}

TEST(RunRecord, AFileThatIsNoSummaryIsRefused) {
  for (const char* text : {"", "[1, 2]", "{\"scenario\": 3}", "{\"scenario\": \"s\"", "{}"}) {
    const TempFolder folder;
    (void)folder.write("trace.csv", "tick,a\n0,1\n");
    const auto file = folder.write("summary.json", text);
    EXPECT_THAT([&] { (void)read_run_record(file.parent_path(), "trace.csv", "summary.json"); },
                ThrowsMessage<InputError>(HasSubstr("summary.json: is no summary of 'armature run'")))
        << text;
  }
}

TEST(RunRecord, AFolderThatIsMissingIsRefused) {
  const TempFolder folder;
  EXPECT_THAT([&] { (void)read_run_record(folder.write("x", "").parent_path() / "none", "t", "s"); },
              ThrowsMessage<InputError>(HasSubstr("none: is no folder")));
}

}  // namespace
}  // namespace armature::cosim
