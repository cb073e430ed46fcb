#include "cosim/iss/debug/protocol/stub.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "cosim/iss/debug/protocol/hex.hpp"
#include "cosim/iss/debug/protocol/packet.hpp"

namespace armature::cosim::iss {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A run that keeps what is asked of it.
struct FakeTarget final : Target {
  std::map<std::pair<int, int>, std::uint64_t> registers_;
  std::map<std::uint32_t, std::uint8_t> memory;
  std::vector<Resume> resumes;
  std::vector<StopPoint> points;
  int interrupts = 0;
  bool may_write = true;

  Registers registers(int core) override {
    Registers all{};
    for (int i = 0; i < kRegisters; ++i) all.at(static_cast<std::size_t>(i)) = registers_[{core, i}];
    return all;
  }
  bool write_register(int core, int number, std::uint64_t value) override {
    if (may_write) registers_[{core, number}] = value;
    return may_write;
  }
  std::vector<std::uint8_t> read_memory(std::uint32_t address, std::uint32_t bytes) override {
    std::vector<std::uint8_t> read;
    for (; read.size() < bytes && memory.contains(address); ++address) read.push_back(memory[address]);
    return read;
  }
  bool write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) override {
    if (!may_write) return false;
    for (const std::uint8_t byte : bytes) memory[address++] = byte;
    return true;
  }
  std::string state(int core) override { return core == 0 ? "executes" : "waits"; }
  std::string monitor(std::string_view command) override { return command == "nothing" ? "" : "heard\n"; }
  void resume(const Resume& how, std::span<const StopPoint> all) override {
    resumes.push_back(how);
    points.assign(all.begin(), all.end());
  }
  void detach() override {}
  void interrupt() override { ++interrupts; }
};

struct GdbStub : testing::Test {
  FakeTarget target;
  Stub stub{target, {}};

  std::string answer(std::string_view packet) { return stub.answer(packet).value_or("(none)"); }
  void send(std::string_view packet) { (void)stub.answer(packet); }
  void stop(const Stop& stop) { (void)stub.stopped(stop); }
};

TEST_F(GdbStub, SaysWhatItCanDo) {
  EXPECT_THAT(answer("qSupported:multiprocess+;swbreak+"), HasSubstr("qXfer:features:read+"));
  EXPECT_EQ(answer("vCont?"), "vCont;c;C;s;S;r");
  for (const char* unknown : {"vMustReplyEmpty", "qTStatus", "X0,0:", "!", "Z5,0,4"}) {
    EXPECT_EQ(answer(unknown), "") << unknown;
  }
}

TEST_F(GdbStub, DescribesTheRegistersInParts) {
  std::string text;
  for (std::string part = "m"; part[0] == 'm'; text += part.substr(1)) {
    part = answer("qXfer:features:read:target.xml:" + fmt::format("{:x}", text.size()) + ",100");
  }
  EXPECT_EQ(text, target_description());
  EXPECT_EQ(answer("qXfer:features:read:other.xml:0,100"), "E00");
  EXPECT_EQ(answer("qXfer:features:read:target.xml:0"), "E01");
}

TEST_F(GdbStub, HasACoreForEachThread) {
  EXPECT_EQ(answer("qfThreadInfo"), "m1,2");
  EXPECT_EQ(answer("qsThreadInfo"), "l");
  EXPECT_EQ(answer("T2"), "OK");
  EXPECT_EQ(answer("T3"), "E01");
  EXPECT_EQ(answer("qThreadExtraInfo,2"), to_hex(std::string_view{"core 1: waits"}));
}

TEST_F(GdbStub, ReadsAndWritesRegistersOfTheSelectedThread) {
  EXPECT_EQ(answer("Hg2"), "OK");
  EXPECT_EQ(answer("Pf=80001000"), "OK");
  EXPECT_EQ((target.registers_[{1, 15}]), 0x00100080u);
  EXPECT_EQ(answer("P11=0000000000000440"), "OK");  // d0
  EXPECT_EQ(answer("pf"), "80001000");
  EXPECT_EQ(answer("p11"), "0000000000000440");
  const std::string all = answer("g");
  EXPECT_EQ(all.size(), 2 * (17 * 4 + 32 * 8 + 4u));
  EXPECT_EQ(answer("Hg1"), "OK");
  EXPECT_EQ(answer("G" + all), "OK");
  EXPECT_EQ((target.registers_[{0, 15}]), 0x00100080u);
}

TEST_F(GdbStub, ReadsAndWritesMemory) {
  EXPECT_EQ(answer("M100,2:aabb"), "OK");
  EXPECT_EQ(answer("m100,2"), "aabb");
  EXPECT_EQ(answer("m100,8"), "aabb");  // as far as there is memory
  EXPECT_EQ(answer("m200,4"), "E02");
  target.may_write = false;
  EXPECT_EQ(answer("M100,1:00"), "E02");
  EXPECT_EQ(answer("Pf=00000000"), "E02");
}

TEST_F(GdbStub, RefusesWhatIsNotAsTheProtocolSays) {
  for (const char* wrong :
       {"m",           "m1",     "mx,4",    "m1,123456789", "M0,2:aa",    "M0,1:g0",      "M0,1",
        "p",           "p99",    "P",       "Pf",           "P0=00",      "P99=00000000", "G00",
        "Hg3",         "H",      "T",       "Z0",           "Z0,1",       "Z0,1,0",       "Z2,x,4",
        "Z0,1,4;X1,0", "vCont;", "vCont;x", "vCont;s:9",    "vCont;r1:1", "qRcmd,1",      "qThreadExtraInfo,"}) {
    const std::string found = answer(wrong);
    EXPECT_TRUE(found == "E01" || found.empty()) << wrong << ": " << found;
  }
  EXPECT_THAT(target.resumes, IsEmpty());
  EXPECT_FALSE(stub.runs());
}

TEST_F(GdbStub, ContinuesWithItsStopPointsAndTellsTheStop) {
  EXPECT_EQ(answer("Z0,1000,4"), "OK");
  EXPECT_EQ(answer("Z0,1000,4"), "OK");  // once more: the same
  EXPECT_EQ(answer("Z2,2000,8"), "OK");
  EXPECT_EQ(answer("Z4,3000,1"), "OK");
  EXPECT_EQ(answer("z4,3000,1"), "OK");
  EXPECT_EQ(stub.answer("vCont;c"), std::nullopt);
  EXPECT_TRUE(stub.runs());
  EXPECT_EQ(stub.answer("g"), std::nullopt);
  EXPECT_THAT(target.points, ElementsAre(StopPoint{StopPoint::Kind::kBreakpoint, 0x1000, 4},
                                         StopPoint{StopPoint::Kind::kWrite, 0x2000, 8}));
  EXPECT_EQ(stub.stopped({.why = Stop::Why::kPoint, .core = 1, .point = target.points[0]}), "T05thread:2;swbreak:;");
  EXPECT_EQ(answer("qC"), "QC2");
  EXPECT_EQ(stub.answer("c"), std::nullopt);
  EXPECT_EQ(stub.stopped({.why = Stop::Why::kPoint, .point = target.points[1], .data = 0x2004}),
            "T05thread:1;watch:2004;");
  EXPECT_EQ(answer("?"), "T05thread:1;watch:2004;");
}

TEST_F(GdbStub, StepsTheNamedThread) {
  send("vCont;s:2;c");
  stop({.core = 1});
  send("vCont;c:1;s:2");
  stop({.core = 1});
  send("vCont;r1000,1010:1;c");
  stop({});
  send("vCont;c:1;c");
  ASSERT_EQ(target.resumes.size(), 4u);
  for (const int i : {0, 1}) {
    EXPECT_EQ(target.resumes[static_cast<std::size_t>(i)].how, Resume::How::kStep);
    EXPECT_EQ(target.resumes[static_cast<std::size_t>(i)].core, 1);
  }
  EXPECT_EQ(target.resumes[2].first, 0x1000u);
  EXPECT_EQ(target.resumes[2].last, 0x1010u);
  EXPECT_EQ(target.resumes[3].how, Resume::How::kContinue);
}

TEST_F(GdbStub, GoesBackAndTellsTheBeginningOfTheRun) {
  EXPECT_EQ(stub.answer("bc"), std::nullopt);
  EXPECT_EQ(stub.stopped({.why = Stop::Why::kBeginning}), "T05thread:1;replaylog:begin;");
  answer("Hc2");
  EXPECT_EQ(stub.answer("bs"), std::nullopt);
  ASSERT_EQ(target.resumes.size(), 2u);
  EXPECT_EQ(target.resumes[0].how, Resume::How::kBack);
  EXPECT_EQ(target.resumes[1].how, Resume::How::kStepBack);
  EXPECT_EQ(target.resumes[1].core, 1);
}

TEST_F(GdbStub, ExecutesNothingInTheStepOfGdbBehindAWatchedAccess) {
  send("c");
  stop({.why = Stop::Why::kPoint, .point = {StopPoint::Kind::kWrite, 0x2000, 4}, .data = 0x2000});
  EXPECT_EQ(answer("vCont;s:1"), "T05thread:1;");
  EXPECT_EQ(target.resumes.size(), 1u);
  send("vCont;s:1");  // that of the user
  EXPECT_EQ(target.resumes.size(), 2u);
}

TEST_F(GdbStub, InterruptsOnlyARunThatContinues) {
  stub.interrupt();
  EXPECT_EQ(target.interrupts, 0);
  send("c");
  stub.interrupt();
  EXPECT_EQ(target.interrupts, 1);
  EXPECT_EQ(stub.stopped({.why = Stop::Why::kInterrupt}), "T02thread:1;");
}

TEST_F(GdbStub, TellsTheEndOfTheRunWithItsExitCode) {
  send("c");
  EXPECT_EQ(stub.stopped({.why = Stop::Why::kEnded, .exit_code = 1}), "W01");
  EXPECT_EQ(stub.stopped({.why = Stop::Why::kFailed}), "X06");
}

TEST_F(GdbStub, PassesMonitorCommands) {
  EXPECT_EQ(answer("qRcmd," + to_hex(std::string_view{"tick"})), to_hex(std::string_view{"heard\n"}));
  EXPECT_EQ(answer("qRcmd," + to_hex(std::string_view{"nothing"})), "OK");
}

TEST_F(GdbStub, EndsTheSessionByDetachOrKill) {
  EXPECT_EQ(answer("D"), "OK");
  EXPECT_EQ(stub.end(), Stub::End::kDetached);
  stub.begin_session();
  EXPECT_EQ(stub.end(), Stub::End::kNone);
  EXPECT_EQ(answer("vKill;1"), "OK");
  EXPECT_EQ(stub.end(), Stub::End::kKilled);
}

TEST_F(GdbStub, ForgetsTheStopPointsOfTheSessionBefore) {
  EXPECT_EQ(answer("QStartNoAckMode"), "OK");
  EXPECT_FALSE(stub.acknowledges());
  answer("Z0,1000,4");
  stub.begin_session();
  EXPECT_TRUE(stub.acknowledges());
  send("c");
  EXPECT_THAT(target.points, IsEmpty());
}

TEST_F(GdbStub, HasALimitedNumberOfStopPoints) {
  for (std::size_t i = 0; i < kMostStopPoints; ++i) EXPECT_EQ(answer(fmt::format("Z0,{:x},4", 4 * i)), "OK");
  EXPECT_EQ(answer("Z0,1000,4"), "E02");
}

}  // namespace
}  // namespace armature::cosim::iss
