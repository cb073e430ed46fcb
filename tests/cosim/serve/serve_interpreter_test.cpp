#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "tests/cosim/support/serve_session.hpp"
#include "tests/support/fake_fabric.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using test::ServeSession;
using testing::HasSubstr;
using testing::StartsWith;

// Registers of rtl/REGISTERS.md.
constexpr const char* kRunTimer0Down = "w 0x42800000 0xD2";  // ENT, ENIT, ARHT, UDT
constexpr const char* kAckTimer0 = "w 0x42800000 0x1D2";
constexpr const char* kReadCounter = "r 0x42800008";

// Timer 0 rolls over every 2500 cycles and raises its interrupt.
void start_tick(ServeSession& session) {
  ASSERT_EQ(session("w 0x42800004 2498"), "ok");
  ASSERT_EQ(session("w 0x42800000 0x20"), "ok");
  ASSERT_EQ(session(kRunTimer0Down), "ok");
}

std::int64_t cycle_of(const std::string& answer) {
  EXPECT_TRUE(std::regex_match(answer, std::regex{"ok [0-9]+"})) << answer;
  return answer.size() > 3 ? std::stoll(answer.substr(3)) : -1;
}

TEST(ServeInterpreter, ReadsWhatWasWritten) {
  ServeSession session;
  EXPECT_EQ(session("w 0x42800004 0xdeadBEEF"), "ok");
  EXPECT_EQ(session("r 0x42800004"), "ok 0xDEADBEEF");
  EXPECT_EQ(session("w 1115684884 7"), "ok") << "decimal 0x42800014";
  EXPECT_EQ(session("r 0X42800014"), "ok 0x00000007");
}

TEST(ServeInterpreter, WritesTheStrobedBytesOnly) {
  ServeSession session;
  EXPECT_EQ(session("w 0x43C20080 0x112233"), "ok");
  EXPECT_EQ(session("w 0x43C20080 0xAABBCC 0b10").substr(0, 6), "error ");
  EXPECT_EQ(session("r 0x43C20080"), "ok 0x00112233");
  EXPECT_EQ(session("w 0x43C20080 0xAABBCC 2"), "ok");
  EXPECT_EQ(session("r 0x43C20080"), "ok 0x0011BB33");
  EXPECT_EQ(session("w 0x43C20080 0xFFFFFF 0"), "ok");
  EXPECT_EQ(session("r 0x43C20080"), "ok 0x0011BB33");
}

TEST(ServeInterpreter, AnAccessTakesTheClocksOfTheBusAndTheMastersLatencyEachWay) {
  ServeSession session;
  // rtl/axi/README.md: 5 and 6 clocks from the acceptance to VALID, one more until the master has taken it.
  EXPECT_EQ(session("time"), "ok 0");
  session("r 0x42800004");
  EXPECT_EQ(session("time"), "ok 18");
  session("w 0x42800004 1");
  EXPECT_EQ(session("time"), "ok 37");
}

TEST(ServeInterpreter, NothingButAccessesAndRunsTakesTime) {
  ServeSession session;
  for (const char* line : {"time", "pin step_o", "pin home_i 1", "help", "help pin", "vcd", "run 0", "run-until-irq 0",
                           "r", "r 1 2", "w 4", "nonsense", "", "run 99999999999"}) {
    session(line);
    EXPECT_EQ(session("time"), "ok 0") << line;
  }
}

TEST(ServeInterpreter, RunsExactlyTheCyclesAskedForWhateverThePinsDo) {
  ServeSession session;
  start_tick(session);
  const std::int64_t before = cycle_of(session("time"));
  EXPECT_EQ(session("run 1"), "ok " + std::to_string(before + 1));
  EXPECT_EQ(session("run 100000"), "ok " + std::to_string(before + 100001));
  EXPECT_EQ(session("time"), "ok " + std::to_string(before + 100001));
}

TEST(ServeInterpreter, RunsUntilAnInterruptIsHigh) {
  ServeSession session;
  start_tick(session);
  const std::int64_t first = cycle_of(session("run-until-irq 5000"));
  EXPECT_EQ(session("pin irq_o"), "ok 0x1");
  EXPECT_EQ(session("run-until-irq 5000"), "ok " + std::to_string(first)) << "it is a level";
  EXPECT_EQ(session(kAckTimer0), "ok");
  EXPECT_EQ(session("pin irq_o"), "ok 0x0");
  EXPECT_EQ(session("run-until-irq 5000"), "ok " + std::to_string(first + 2500));
}

TEST(ServeInterpreter, AMissingInterruptIsAnErrorAfterExactlyThatTime) {
  std::int64_t wait = 0;
  {
    ServeSession session;
    EXPECT_EQ(session("run-until-irq 1000"), "error no interrupt within 1000 cycles");
    EXPECT_EQ(session("time"), "ok 1000");
    start_tick(session);
    const std::int64_t started = cycle_of(session("time"));
    wait = cycle_of(session("run-until-irq 5000")) - started;
  }
  ServeSession again;
  start_tick(again);
  const std::int64_t started = cycle_of(again("time"));
  const std::string within = std::to_string(wait - 1);
  EXPECT_EQ(again("run-until-irq " + within), "error no interrupt within " + within + " cycles");
  EXPECT_EQ(again("run-until-irq 1"), "ok " + std::to_string(started + wait));
}

TEST(ServeInterpreter, RefusedAccessesAreAnswersAndNotTheEnd) {
  ServeSession session;
  EXPECT_EQ(session("r 0x43C10FFC"), "error SLVERR at 0x43C10FFC: the block refused the access");
  EXPECT_EQ(session("w 0x43C10000 1"), "error SLVERR at 0x43C10000: the block refused the access");
  EXPECT_EQ(session("r 0x10000000"), "error DECERR at 0x10000000: there is no block");
  EXPECT_EQ(session("w 0xFFFFFFFF 1"), "error DECERR at 0xFFFFFFFF: there is no block");
  EXPECT_EQ(session("r 0x43C10000"), "ok 0x50540106");
}

TEST(ServeInterpreter, AReleasedOutputOfTheToolReadsItsPin) {
  ServeSession session;
  EXPECT_EQ(session("r 0x41200004"), "ok 0x0000FFFF");
  EXPECT_EQ(session("w 0x41200000 0xa5"), "ok");
  EXPECT_EQ(session("r 0x41200000"), "ok 0x00000000");
  EXPECT_EQ(session("pin gpio_o"), "ok 0x0");
  EXPECT_EQ(session("w 0x41200004 0"), "ok");
  EXPECT_EQ(session("r 0x41200000"), "ok 0x000000A5");
  EXPECT_EQ(session("pin gpio_o"), "ok 0xA5");
}

// As with RTS and CTS between two devices: each side holds its transmitter while the other is not ready.
TEST(ServeInterpreter, TheModemLinesOfTheUartArePins) {
  ServeSession session;
  EXPECT_EQ(session("pin uart_rts_no"), "ok 0x1") << "inactive";
  EXPECT_EQ(session("w 0x43C01010 0x3"), "ok");  // MCR: DTR, RTS
  EXPECT_EQ(session("pin uart_rts_no"), "ok 0x0");
  EXPECT_EQ(session("pin uart_dtr_no"), "ok 0x0");
  EXPECT_EQ(session("r 0x43C01018"), "ok 0x00000000") << "inputs are inactive";
  EXPECT_EQ(session("w 0x43C01004 0x8"), "ok");  // IER: modem status
  EXPECT_EQ(session("pin uart_cts_ni 0"), "ok");
  EXPECT_EQ(session("run-until-irq 100").substr(0, 3), "ok ");
  EXPECT_EQ(session("pin irq_o"), "ok 0x2");
  EXPECT_EQ(session("r 0x43C01008"), "ok 0x00000000") << "IIR: modem status";
  EXPECT_EQ(session("r 0x43C01018"), "ok 0x00000011") << "MSR: CTS and its change";
  EXPECT_EQ(session("pin irq_o"), "ok 0x0");
  for (const char* pin : {"uart_dsr_ni", "uart_dcd_ni", "uart_ri_ni"}) {
    EXPECT_EQ(session(std::string{"pin "} + pin + " 0"), "ok");
  }
  EXPECT_EQ(session("run 10").substr(0, 3), "ok ");
  EXPECT_EQ(session("r 0x43C01018"), "ok 0x000000FA");
}

// On a Zynq a write that answers SLVERR is an external abort.
TEST(ServeInterpreter, BlocksWithAVendorsMapIgnoreWritesToReadOnlyAndReservedWords) {
  ServeSession session;
  EXPECT_EQ(session("w 0x42800004 0x1234"), "ok");
  EXPECT_EQ(session("w 0x42800000 0x20"), "ok");
  for (const char* address : {"0x42800008", "0x4280000C", "0x42800018", "0x4280001C",  // TCR0, reserved, TCR1, reserved
                              "0x43C00000", "0x43C01014", "0x43C01018", "0x43C01020",  // unused, LSR, MSR, unused
                              "0x41200010", "0x41200118", "0x41200124", "0x412001FC"}) {  // reserved
    EXPECT_EQ(session(std::string{"w "} + address + " 0xFFFFFFFF"), "ok") << address;
  }
  EXPECT_EQ(session(kReadCounter), "ok 0x00001234");
  EXPECT_EQ(session("r 0x4280000C"), "ok 0x00000000");
  EXPECT_EQ(session("r 0x43C01014"), "ok 0x00000060");
  EXPECT_EQ(session("r 0x43C01018"), "ok 0x00000000");
  for (const char* address : {"0x42800020", "0x43C02000", "0x41200200"}) {
    const std::string what = std::string{"error SLVERR at "} + address + ": the block refused the access";
    EXPECT_EQ(session(std::string{"w "} + address + " 1"), what);
    EXPECT_EQ(session(std::string{"r "} + address), what);
  }
}

TEST(ServeInterpreter, ABusThatDoesNotAnswerIsAnErrorAfterTheTimeOut) {
  ServeSession session{std::make_unique<FakeFabric>()};
  EXPECT_EQ(session("r 0x4"), "error TIMEOUT at 0x00000004: no answer within 1000 cycles");
  EXPECT_EQ(session("w 0x4 0"), "error TIMEOUT at 0x00000004: no answer within 1000 cycles");
}

TEST(ServeInterpreter, AStopRequestEndsALongRun) {
  int asked = 0;
  ServeSession session{std::make_unique<FakeFabric>(), [&asked] { return ++asked % 3 == 0; }};
  EXPECT_EQ(session("run 1000000000"), "error interrupted at cycle 12288");
  EXPECT_EQ(session("run-until-irq 1000000000"), "error interrupted at cycle 24576");
  EXPECT_EQ(session("run 100"), "ok 24676") << "short ones are not asked about";
  EXPECT_EQ(asked, 6);
}

// Fails at its first clock.
class FailingFabric : public Fabric {
 public:
  void set_inputs(const SocInputs&) override {}
  void set_master(const AxiMasterPins&) override {}
  bool run(std::int64_t) override { throw LogicCheckFailed{Cycles{7}}; }
  [[nodiscard]] const SocOutputs& outputs() const override { return outputs_; }
  [[nodiscard]] AxiSlavePins slave() const override { return {}; }
  void stand_still(std::int64_t) override {}
  void stop_clock_of(ClockGroup) override {}
  [[nodiscard]] Cycles cycle() const override { return Cycles{6}; }
  void open_wave(const std::filesystem::path&, WaveFormat) override {}
  void close_wave() override {}

 private:
  SocOutputs outputs_;
};

TEST(ServeInterpreter, AFailedCheckInsideTheLogicIsSaidAndRemembered) {
  ServeSession session{std::make_unique<FailingFabric>()};
  EXPECT_EQ(session("time"), "ok 6");
  EXPECT_FALSE(session.interpreter.broken());
  EXPECT_EQ(session("run 5"), "error a check inside the logic failed at cycle 7; the server ends");
  EXPECT_TRUE(session.interpreter.broken());
}

TEST(ServeInterpreter, InputsReachTheLogic) {
  ServeSession session;
  EXPECT_EQ(session("pin home_i"), "ok 0x0");
  EXPECT_EQ(session("pin home_i 0x21"), "ok");
  EXPECT_EQ(session("pin limit_pos_i 0x12"), "ok");
  EXPECT_EQ(session("pin limit_neg_i 12"), "ok");
  EXPECT_EQ(session("run 10"), "ok 10");
  EXPECT_EQ(session("r 0x43C10030"), "ok 0x000C1221");
  EXPECT_EQ(session("pin home_i"), "ok 0x21");
  EXPECT_EQ(session("pin estop_ni"), "ok 0x1") << "released";
  EXPECT_EQ(session("pin uart_rxd_i"), "ok 0x1") << "idle";
}

TEST(ServeInterpreter, OutputsShowWhatTheLogicDrives) {
  ServeSession session;
  EXPECT_EQ(session("pin servo_on_o"), "ok 0x0");
  EXPECT_EQ(session("w 0x43C10004 0x2A"), "ok");
  EXPECT_EQ(session("pin servo_on_o"), "ok 0x2A");
  EXPECT_EQ(session("pin estop_ni 0"), "ok");
  EXPECT_EQ(session("run 10"), "ok 29");
  EXPECT_EQ(session("pin servo_on_o"), "ok 0x0");
}

TEST(ServeInterpreter, BadInputNamesWhatWasExpected) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "error no command; 'help' lists them"},
      {" \t ", "error no command; 'help' lists them"},
      {"R 0", "error no command 'R'; 'help' lists them"},
      {"read 0", "error no command 'read'; 'help' lists them"},
      {"r", "error ADDR is missing; usage: r ADDR"},
      {"r 0 0", "error unexpected '0'; usage: r ADDR"},
      {"r 0x100000000",
       "error ADDR must be 0..4294967295 (0xFFFFFFFF), decimal or 0x..., found '0x100000000'; usage: r ADDR"},
      {"r -1", "error ADDR must be 0..4294967295 (0xFFFFFFFF), decimal or 0x..., found '-1'; usage: r ADDR"},
      {"r +1", "error ADDR must be 0..4294967295 (0xFFFFFFFF), decimal or 0x..., found '+1'; usage: r ADDR"},
      {"r 0x", "error ADDR must be 0..4294967295 (0xFFFFFFFF), decimal or 0x..., found '0x'; usage: r ADDR"},
      {"r 10h", "error ADDR must be 0..4294967295 (0xFFFFFFFF), decimal or 0x..., found '10h'; usage: r ADDR"},
      {"r FF", "error ADDR must be 0..4294967295 (0xFFFFFFFF), decimal or 0x..., found 'FF'; usage: r ADDR"},
      {"w", "error ADDR is missing; usage: w ADDR DATA [STRB]"},
      {"w 4", "error DATA is missing; usage: w ADDR DATA [STRB]"},
      {"w 4 x",
       "error DATA must be 0..4294967295 (0xFFFFFFFF), decimal or 0x..., found 'x'; usage: w ADDR DATA [STRB]"},
      {"w 4 5 16", "error STRB must be 0..15 (0xF), decimal or 0x..., found '16'; usage: w ADDR DATA [STRB]"},
      {"w 4 5 6 7", "error unexpected '7'; usage: w ADDR DATA [STRB]"},
      {"run", "error CYCLES is missing; usage: run CYCLES"},
      {"run 1000000001",
       "error CYCLES must be 0..1000000000 (0x3B9ACA00), decimal or 0x..., found '1000000001'; usage: run CYCLES"},
      {"run 99999999999999999999999",
       "error CYCLES must be 0..1000000000 (0x3B9ACA00), decimal or 0x..., found '99999999999999999999999'; "
       "usage: run CYCLES"},
      {"run 1 2", "error unexpected '2'; usage: run CYCLES"},
      {"run-until-irq", "error MAX is missing; usage: run-until-irq MAX"},
      {"time 1", "error unexpected '1'; usage: time"},
      {"pin", "error NAME is missing; usage: pin NAME [VALUE]"},
      {"pin step", "error no pin 'step', did you mean step_o?"},
      {"pin zzzzzzzzzz", "error no pin 'zzzzzzzzzz'; 'help pin' lists them"},
      {"pin step_o 1", "error step_o is an output of the logic"},
      {"pin clk_i", "error 'clk_i' is moved by run and by every access"},
      {"pin clk_\xff", "error 'clk_?' is moved by run and by every access"},
      {"pin rst_ni 0", "error rst_ni was released before cycle 0 and stays high"},
      {"pin s_axi_awaddr_i", "error the bus belongs to r and w, it is idle between them"},
      {"pin home_i 64", "error VALUE must be 0..63 (0x3F), decimal or 0x..., found '64'; usage: pin NAME [VALUE]"},
      {"pin estop_ni 2", "error VALUE must be 0..1 (0x1), decimal or 0x..., found '2'; usage: pin NAME [VALUE]"},
      {"pin gpio_i 65536",
       "error VALUE must be 0..65535 (0xFFFF), decimal or 0x..., found '65536'; usage: pin NAME [VALUE]"},
      {"pin home_i 1 1", "error unexpected '1'; usage: pin NAME [VALUE]"},
      {"help me", "error no command 'me'; 'help' lists them"},
      {"help r w", "error unexpected 'w'; usage: help [COMMAND]"},
      {"\x01\xFF", "error no command '?\?'; 'help' lists them"},
      {std::string(100, 'a'), "error no command '" + std::string(40, 'a') + "...'; 'help' lists them"},
  };
  ServeSession session;
  for (const auto& [line, answer] : cases) EXPECT_EQ(session(line), answer) << line;
  EXPECT_EQ(session("pin home_i"), "ok 0x0") << "what is refused has no effect";
  EXPECT_EQ(session.interpreter.lines(), static_cast<std::int64_t>(cases.size()) + 1);
}

// As the vendor's interrupt example does: channel 1 is an input after reset, and a button changes its level.
TEST(ServeInterpreter, ChannelOneOfTheGpioInterruptsAsAnInput) {
  ServeSession session;
  EXPECT_EQ(session("w 0x41200128 1"), "ok");           // IER: channel 1
  EXPECT_EQ(session("w 0x4120011C 0x80000000"), "ok");  // GIER
  EXPECT_EQ(session("run-until-irq 100"), "error no interrupt within 100 cycles");
  for (const char* levels : {"0x0000A5C3", "0x00000000"}) {
    EXPECT_EQ(session(std::string{"pin gpio1_i "} + levels), "ok");
    EXPECT_THAT(session("run-until-irq 100"), StartsWith("ok "));
    EXPECT_EQ(session("pin irq_o"), "ok 0x4");
    EXPECT_EQ(session("r 0x41200000"), std::string{"ok "} + levels);
    EXPECT_EQ(session("r 0x41200120"), "ok 0x00000001");
    EXPECT_EQ(session("w 0x41200120 1"), "ok");
    EXPECT_EQ(session("pin irq_o"), "ok 0x0");
  }
}

TEST(ServeInterpreter, BlanksAndCarriageReturnsAreNoMistake) {
  ServeSession session;
  EXPECT_EQ(session("\t w   0x42800004\t5  "), "ok");
  EXPECT_EQ(session("r 0x42800004\r"), "ok 0x00000005");
  EXPECT_EQ(session(" time \t"), "ok 37");
}

TEST(ServeInterpreter, HelpNamesEveryCommandAndEachExplainsItself) {
  ServeSession session;
  const std::string all = session("help");
  for (const char* usage : {"r ADDR", "w ADDR DATA [STRB]", "run CYCLES", "run-until-irq MAX", "pin NAME [VALUE]",
                            "time", "batch OPERATION; ...", "vcd [FILE]", "help [COMMAND]"}) {
    EXPECT_THAT(all, HasSubstr(usage));
    const std::string name = std::string{usage}.substr(0, std::string_view{usage}.find(' '));
    EXPECT_THAT(session("help " + name), StartsWith("ok " + std::string{usage} + ": "));
  }
}

TEST(ServeInterpreter, TheSameCommandsGiveTheSameAnswers) {
  const auto answers_of = [](std::uint64_t seed) {
    armature::test::SplitMix random{seed};
    ServeSession session;
    start_tick(session);
    std::string answers;
    for (int i = 0; i < 2000; ++i) {
      const std::uint32_t addr = (random.below(2) == 0 ? 0x42800000u : 0x43C10000u) + 4 * random.below(12);
      switch (random.below(4)) {
        case 0:
          answers += session("r " + std::to_string(addr));
          break;
        case 1:
          answers += session("w " + std::to_string(addr) + " " + std::to_string(random.below(300)));
          break;
        case 2:
          answers += session("run " + std::to_string(random.below(100)));
          break;
        default:
          answers += session("pin limit_pos_i " + std::to_string(random.below(64)));
          answers += session("run-until-irq 300");
      }
    }
    return answers + session("time");
  };
  EXPECT_EQ(answers_of(11), answers_of(11));
  EXPECT_NE(answers_of(11), answers_of(12));
}

TEST(ServeInterpreter, ServesTheVariantOfThePaper) {
  ServeSession session{make_verilated_fabric(Variant::kPaper)};
  start_tick(session);
  EXPECT_THAT(session("run-until-irq 5000"), StartsWith("ok "));
  EXPECT_THAT(session(kReadCounter), StartsWith("ok 0x0000"));
  EXPECT_EQ(session("r 0x43C10000"), "ok 0x50570106") << "pulse_width";
  EXPECT_THAT(session("r 0x43C30000"), StartsWith("ok ")) << "encoder_switch";
}

TEST(ServeInterpreter, TheOtherVariantHasNoEncoderSwitch) {
  ServeSession session{make_verilated_fabric()};
  EXPECT_EQ(session("r 0x43C10000"), "ok 0x50540106") << "pulse_train";
  EXPECT_THAT(session("r 0x43C30000"), StartsWith("error ")) << "DECERR";
}

}  // namespace
}  // namespace armature::cosim
