// encoder and its model, clock for clock: six decoders, and the one of the paper's variant.
#include <array>
#include <string>

#include "Vencoder.h"
#include "Vencoder_single.h"
#include "controller/regs/encoder_regs.hpp"
#include "cosim/model/encoder/encoder.hpp"
#include "tests/rtl/model/block_lockstep.hpp"

namespace armature::test {
namespace {

namespace regs = armature::regs::encoder;
using cosim::model::Encoder;
using cosim::model::EncoderInputs;

// An encoder that turns, with everything that disturbs one.
class TurningEncoder {
 public:
  struct Lines {
    bool a = false, b = false, z = false;
  };

  Lines next(SplitMix& random, std::uint32_t shortest) {
    if (random.below(3000) == 0) period_ = random.below(4) == 0 ? 0 : shortest + random.below(300);
    if (random.below(2000) == 0) up_ = !up_;
    if (period_ != 0 && ++age_ >= period_) {
      age_ = 0;
      count_ += up_ ? 1u : ~0u;
      if (random.below(300) == 0) count_ += 2;  // an illegal transition
      bounce_ = random.below(3) == 0 ? random.below(12) : 0;
    }
    Lines lines{.a = ((count_ + 1) & 2) != 0, .b = (count_ & 2) != 0, .z = count_ % 44 == 0};
    if (random.below(900) == 0) glitch_ = 1 + random.below(12);
    if (glitch_ != 0 && --glitch_ != 0) (glitch_ % 3 == 0 ? lines.z : glitch_ % 3 == 1 ? lines.a : lines.b) ^= true;
    if (bounce_ != 0 && --bounce_ != 0 && random.below(2) == 0) lines.a = !lines.a;
    return lines;
  }

 private:
  std::uint32_t period_ = 40, age_ = 0, count_ = 0, glitch_ = 0, bounce_ = 0;
  bool up_ = true;
};

template <class Dut, std::size_t kDecoders>
class EncoderFixture : public BlockLockstep<Dut, Encoder<kDecoders>, EncoderInputs> {
 protected:
  // Often the registers that matter, now and then any offset and any bytes.
  BusTraffic random_write() override {
    SplitMix& random = this->random_;
    const auto any = static_cast<std::uint32_t>(random.next());
    switch (random.below(10)) {
      case 0:
        return {regs::kDebounceOffset, random.below(4) == 0 ? random.below(40) : random.below(8)};
      case 1:
        return {regs::kFilterOffset, random.below(2)};
      case 2:
        return {regs::kKeyOffset, random.below(2) == 0 ? regs::kKeyWord : any};
      case 3:
        return {regs::kIndexCheckOffset, any};
      case 4:
      case 5:
        return {regs::kFaultOffset, random.below(2) == 0 ? any : ~0u};
      case 6:
        return {regs::kCountsPerRevOffset + 4 * random.below(6), random.below(2) == 0 ? 44 : any};
      default:
        return {random.below(random.below(8) == 0 ? 0x10000 : 0x100), any, static_cast<std::uint8_t>(random.below(16))};
    }
  }
  std::uint16_t random_read() override {
    return static_cast<std::uint16_t>(this->random_.below(this->random_.below(20) == 0 ? 0x10000 : 0xF0));
  }

  void change_inputs() override {
    EncoderInputs& in = this->inputs_;
    in.a = in.b = in.z = 0;
    for (std::size_t i = 0; i < kDecoders; ++i) {
      const TurningEncoder::Lines lines = moves_ ? axes_[i].next(this->random_, shortest_) : TurningEncoder::Lines{};
      in.a |= static_cast<std::uint8_t>(lines.a << i);
      in.b |= static_cast<std::uint8_t>(lines.b << i);
      in.z |= static_cast<std::uint8_t>(lines.z << i);
    }
    in.trigger = this->random_.below(trigger_every_) == 0;
    if (this->random_.below(2000) == 0) in.servo_on = this->random_.below(2) == 0 ? 0 : 1;
  }

  void drive_inputs(Dut& dut, const EncoderInputs& in) override {
    dut.trigger_i = in.trigger;
    dut.enc_a_i = in.a;
    dut.enc_b_i = in.b;
    dut.enc_z_i = in.z;
    dut.servo_on_i = in.servo_on;
  }

  std::string difference(const Dut&, const Encoder<kDecoders>&) override { return {}; }  // it has no output but the bus

  void run_in_all_styles() {
    for (const std::uint32_t shortest : {3u, 12u, 25u}) {
      shortest_ = shortest;
      for (const std::uint32_t every : {7u, 100u, 2500u}) {
        trigger_every_ = every;
        this->run(40'000, 8, 1);
      }
    }
  }

  std::array<TurningEncoder, kDecoders> axes_{};
  std::uint32_t shortest_ = 25, trigger_every_ = 100;
  bool moves_ = true;
};

using EncoderLockstep = EncoderFixture<Vencoder, 6>;
using SingleEncoderLockstep = EncoderFixture<Vencoder_single, 1>;

TEST_F(EncoderLockstep, RandomTrafficAndTurningEncoders) {
  run_in_all_styles();
}

TEST_F(SingleEncoderLockstep, RandomTrafficAndATurningEncoder) {
  run_in_all_styles();
}

TEST_F(EncoderLockstep, AnIdleEncoderNeedsNoEdge) {
  moves_ = false;
  trigger_every_ = 2500;
  run(100'000, 2'000, 1);
  EXPECT_LT(needed_.computed, 100'000 / 50);
}

TEST_F(EncoderLockstep, AGatedClockThatStops) {
  run(20'000, 8, 1);
  stop_gated_clock();
  run(20'000, 8, 1);
}

}  // namespace
}  // namespace armature::test
