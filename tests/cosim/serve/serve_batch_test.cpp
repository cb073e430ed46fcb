#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cosim/serve/interpreter.hpp"
#include "tests/cosim/support/serve_session.hpp"

namespace armature::cosim {
namespace {

using test::ServeSession;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ServeBatch, ABatchGivesWhatItsOperationsGiveAlone) {
  ServeSession batch, alone;
  EXPECT_EQ(batch("batch w 0x42800004 5;r 0x42800004; run 100 ;pin home_i 3;pin home_i;time"),
            "ok - 0x00000005 137 - 0x3 137");
  for (const char* line : {"w 0x42800004 5", "r 0x42800004", "run 100", "pin home_i 3"}) alone(line);
  EXPECT_EQ(alone("time"), batch("time"));
}

TEST(ServeBatch, ABatchEndsAtTheFirstOperationThatFails) {
  ServeSession session;
  EXPECT_EQ(session("batch w 0x42800004 5;r 0x42800004;vcd x;run 100"),
            "error operation 2 of 4: 'vcd' cannot be in a batch; r, w, run, run-until-irq, pin, time can; "
            "executed 0..1: - 0x00000005");
  EXPECT_EQ(session("time"), "ok 37");
  EXPECT_EQ(session("batch r 0x10000000;run 100"),
            "error operation 0 of 2: DECERR at 0x10000000: there is no block; executed none");
  EXPECT_THAT(session("batch time;;time"), HasSubstr("operation 1 of 3: an operation is missing; executed 0..0: "));
  EXPECT_THAT(session("batch"), HasSubstr("operation 0 of 1: an operation is missing; executed none"));
}

TEST(ServeBatch, ABatchHasAtMostSoManyOperationsAndBytes) {
  ServeSession session;
  std::string most = "batch time";
  for (std::size_t i = 1; i < Interpreter::kMaxOperations; ++i) most += ";time";
  EXPECT_THAT(session(most), StartsWith("ok 0 0 0"));
  EXPECT_EQ(session(most + ";time"), "error a batch has at most 4096 operations, found 4097");
  EXPECT_EQ(session("time" + std::string(Interpreter::kMaxLine, ' ')),
            "error a line has at most 4096 bytes, a batch 131072");
}

}  // namespace
}  // namespace armature::cosim
