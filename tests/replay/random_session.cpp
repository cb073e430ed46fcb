#include "tests/replay/random_session.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "controller/regs/axi_gpio_regs.hpp"
#include "controller/regs/axi_timer_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/logic/pin_list.hpp"

namespace armature::test {
namespace {

namespace soc = regs::soc;

constexpr std::uint32_t kUartRegisters = 0x1000;
// Base addresses with registers in both variants of the logic. One variant has a gap at the base of encoder_switch.
constexpr std::array kWindows{
    soc::kAxiGpioBase,      soc::kAxiGpioBase + 0x100,    soc::kAxiTimerBase, soc::kAxiUart16550Base + kUartRegisters,
    soc::kPulseTrainBase,   soc::kPulseTrainBase + 0x100, soc::kEncoderBase,  soc::kEncoderBase + 0x100,
    soc::kEncoderSwitchBase};
constexpr std::uint32_t kWindowWords = 64;

constexpr std::uint32_t kUart = soc::kAxiUart16550Base + kUartRegisters;
constexpr std::uint32_t kPulses = soc::kPulseTrainBase;  // also pulse_width, which has the same offsets

// Timer 0 generates triggers, and a small divisor makes the UART fast.
constexpr std::array kSetUp{RandomSession::Write{kPulses + regs::pulse_train::kTickCyclesOffset, 300},
                            RandomSession::Write{soc::kAxiTimerBase + regs::axi_timer::kTlr0Offset, 298},
                            RandomSession::Write{soc::kAxiTimerBase, 0x032},  // LOAD
                            RandomSession::Write{soc::kAxiTimerBase, 0x0D6},
                            RandomSession::Write{kUart + 0x0C, 0x83},
                            RandomSession::Write{kUart, 1},
                            RandomSession::Write{kUart + 4, 0},
                            RandomSession::Write{kUart + 0x0C, 0x03},
                            RandomSession::Write{kUart + 8, 0x81},
                            RandomSession::Write{kUart + 4, 0x0F}};

// Average number of clocks between two changes of an input pin. An emergency stop is short, so that axes move.
constexpr std::string_view kEstop = "estop_ni";
constexpr std::pair<std::string_view, std::uint32_t> kOneIn[] = {
    {"enc_a_i", 8},         {"enc_b_i", 8}, {"enc_z_i", 200}, {"uart_rxd_i", 16},
    {"capture_trig_i", 50}, {"gpio_i", 50}, {"gpio1_i", 50}};
constexpr std::uint32_t kOtherOneIn = 2000;

std::uint32_t one_in(std::string_view pin) {
  for (const auto& [name, clocks] : kOneIn) {
    if (name == pin) return clocks;
  }
  return kOtherOneIn;
}

}  // namespace

void RandomSession::run(cosim::Fabric& fabric, std::int64_t clocks) {
  for (std::int64_t clock = 0; clock < clocks; ++clock) {
    drive_bus(fabric.slave());
    drive_pins();
    fabric.set_master(master_);
    fabric.set_inputs(inputs_);
    const cosim::AxiSlavePins before = fabric.slave();
    fabric.run(1);
    if (master_.awvalid && before.awready) aw_done_ = true, master_.awvalid = false;
    if (master_.wvalid && before.wready) w_done_ = true, master_.wvalid = false;
    if (master_.bready && before.bvalid) writing_ = master_.bready = false;
    if (master_.arvalid && before.arready) master_.arvalid = false;
    if (master_.rready && before.rvalid) reading_ = master_.rready = false;
  }
}

// At most one write and one read are in flight. Each VALID and READY comes after a random delay.
void RandomSession::drive_bus(const cosim::AxiSlavePins& before) {
  const bool swept = sweep_ == kWindows.size() * kWindowWords;
  if (!reading_ && !(swept && random_.below(8) != 0)) {
    reading_ = master_.arvalid = true;
    master_.araddr = swept ? address() : kWindows[sweep_ / kWindowWords] + 4 * (sweep_ % kWindowWords);
    if (!swept) ++sweep_;
  }
  if (swept && !writing_ && random_.below(8) == 0) {
    writing_ = true;
    aw_done_ = w_done_ = false;
    const bool start = set_up_ < kSetUp.size();
    const Write write = start ? kSetUp[set_up_] : random_.below(4) != 0 ? useful_write() : Write{address(), data()};
    master_.awaddr = write.addr;
    master_.wdata = write.data;
    master_.wstrb = start || random_.below(4) != 0 ? 0xF : static_cast<std::uint8_t>(random_.below(16));
    if (start) ++set_up_;
  }
  if (writing_ && !aw_done_ && random_.below(2) == 0) master_.awvalid = true;
  if (writing_ && !w_done_ && random_.below(2) == 0) master_.wvalid = true;
  // A master may wait for VALID.
  if (before.bvalid && random_.below(3) == 0) master_.bready = true;
  if (reading_ && random_.below(3) == 0) master_.rready = true;
}

void RandomSession::drive_pins() {
  for (const cosim::Pin& pin : cosim::kPins) {
    if (!pin.is_input() || pin.name == kEstop || random_.below(one_in(pin.name)) != 0) continue;
    pin.set(inputs_, pin.get(inputs_, {}) ^ 1u << random_.below(static_cast<std::uint32_t>(pin.bits)));
  }
  if (random_.below(4000) == 0) inputs_.estop_n = false;
  if (random_.below(40) == 0) inputs_.estop_n = true;
}

// Writes that start pulses, triggers, the PWM and the serial line again after random writes that stop them.
RandomSession::Write RandomSession::useful_write() {
  namespace pulse = regs::pulse_train;
  namespace timer = regs::axi_timer;
  switch (random_.below(12)) {
    case 0:
      return {kPulses + pulse::kEstopOffset, 6};
    case 1:
      return {kPulses + pulse::kCtrlOffset, 0x13F};
    case 2:
      return {kPulses + pulse::kCommitOffset, random_.below(0x10000)};
    case 3:
      return {kPulses + (random_.below(2) == 0 ? pulse::kDirSetupOffset : pulse::kDirHoldOffset), random_.below(8)};
    case 4:
      return {soc::kAxiTimerBase + timer::kTlr0Offset, 290 + random_.below(16)};
    case 5:
      return {soc::kAxiTimerBase + timer::kTlr1Offset, 50 + random_.below(100)};
    case 6:
      return {soc::kAxiTimerBase + (random_.below(2) == 0 ? timer::kTcsr0Offset : timer::kTcsr1Offset),
              0x2D6 | random_.below(2) << 8};  // with or without TINT
    case 7:
      return {kUart, random_.below(256)};
    case 8:
      return {soc::kAxiGpioBase + regs::axi_gpio::kDataOffset, random_.below(0x10000)};
    case 9:
      return {soc::kAxiGpioBase + regs::axi_gpio::kGierOffset, random_.below(2) << 31};
    case 10:
      return {soc::kAxiGpioBase + (random_.below(2) == 0 ? regs::axi_gpio::kIerOffset : regs::axi_gpio::kIsrOffset), 3};
    default:
      return {kPulses + pulse::kCountOffset + 4 * random_.below(6), random_.below(41) - 20};
  }
}

std::uint32_t RandomSession::address() {
  if (random_.below(50) == 0) return static_cast<std::uint32_t>(random_.next());
  return kWindows[random_.below(kWindows.size())] + 4 * random_.below(kWindowWords) + random_.below(32) / 31;
}

// Small numbers, masks and random words. Small numbers give counts and times that take effect within the session.
std::uint32_t RandomSession::data() {
  switch (random_.below(4)) {
    case 0:
      return random_.below(16);
    case 1:
      return random_.below(512) - 256;
    case 2:
      return 1u << random_.below(32);
    default:
      return static_cast<std::uint32_t>(random_.next());
  }
}

}  // namespace armature::test
