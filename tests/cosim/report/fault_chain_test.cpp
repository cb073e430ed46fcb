// The chain of causes: from what the controller reports to the injected faults that only the simulation knows.
#include "cosim/report/measure/fault_chain.hpp"

#include <gtest/gtest.h>

#include "cosim/report/format/injection_text.hpp"

namespace armature::cosim {
namespace {

InjectedFault injected_at(std::int64_t cycle, const FaultKind& kind) {
  return {.spec = {.at_s = 0, .kind = kind}, .when = {.tick = cycle / 2500, .at = Cycles{cycle}}};
}

const FaultKind kStuckB = EncoderStuck{.axis = 4, .line = EncoderLine::kB, .level = 1, .duration_s = 1};

FaultEvent reported(FaultCause cause, std::uint8_t axis, std::int64_t cycle) {
  return {.cause = cause, .where = {.tick = cycle / 2500, .at = Cycles{cycle}, .axis = axis}};
}

TEST(FaultChain, NamesWhatWasDetectedAndTheFaultOfTheSameAxisBehindIt) {
  RunFacts facts;
  EXPECT_EQ(first_fault_text(facts), "");
  facts.injected_faults = {injected_at(15'000'000, PulseLoss{.axis = 3, .count = 5}), injected_at(15'300'211, kStuckB),
                           injected_at(16'000'000, PulseLoss{.axis = 4, .count = 5})};
  facts.faults = {reported(FaultCause::kFollowingError, 4, 15'400'000)};
  EXPECT_EQ(first_fault_text(facts),
            "following_error of axis 4 at tick 6160: encoder_stuck of axis 4, line b = 1 for 1 s since cycle 15300211");
}

TEST(FaultChain, NamesAllFaultsOfTheAxisAndWhetherTheyWereOver) {
  RunFacts facts;
  facts.injected_faults = {injected_at(2'000, PulseLoss{.axis = 4, .count = 5}), injected_at(3'000, kStuckB)};
  facts.injected_faults[1].ended = Cycles{4'000};
  facts.faults = {reported(FaultCause::kFollowingError, 4, 5'000)};
  EXPECT_EQ(first_fault_text(facts),
            "following_error of axis 4 at tick 2: pulse_loss of axis 4, 5 pulses at cycle 2000, and "
            "encoder_stuck of axis 4, line b = 1 for 1 s since cycle 3000 to cycle 4000");
}

TEST(FaultChain, TakesAFaultWithoutAnAxisBeforeThoseOfOtherAxes) {
  RunFacts facts;
  facts.faults = {reported(FaultCause::kEncoder, 1, 9'000)};
  EXPECT_EQ(cause_text(facts, facts.faults[0].where), "no fault of the scenario");
  facts.injected_faults = {injected_at(2'000, kStuckB)};
  EXPECT_EQ(causes_of(facts, facts.faults[0].where).size(), 1u);
  facts.injected_faults.push_back(injected_at(3'000, StrayWrite{}));
  ASSERT_EQ(causes_of(facts, facts.faults[0].where).size(), 1u);
  EXPECT_EQ(causes_of(facts, facts.faults[0].where)[0].when.at, Cycles{3'000});
}

TEST(FaultChain, BlamesAnAxisThatSomebodyHasMoved) {
  RunFacts facts;
  facts.faults = {reported(FaultCause::kEncoder, 3, 9'000), reported(FaultCause::kEncoder, 4, 9'000)};
  facts.moved_start_deg = {0, 0, 2.5, 0, 0, 0};
  EXPECT_EQ(cause_text(facts, facts.faults[0].where), "moved_start_deg of 2.5 deg");
  EXPECT_EQ(cause_text(facts, facts.faults[1].where), "no fault of the scenario");
}

TEST(FaultChain, DoesNotBlameWhatWasOverBeforeAReset) {
  RunFacts facts;
  facts.injected_faults = {injected_at(2'000, kStuckB), injected_at(2'500, Estop{.duration_s = 1})};
  facts.injected_faults[0].ended = Cycles{3'000};
  facts.injected_faults[1].ended = Cycles{8'000};
  facts.faults = {reported(FaultCause::kFollowingError, 4, 9'000)};
  EXPECT_EQ(causes_of(facts, facts.faults[0].where)[0].when.at, Cycles{2'000});
  facts.resets = {Cycles{4'000}};
  ASSERT_EQ(causes_of(facts, facts.faults[0].where).size(), 1u);
  EXPECT_EQ(causes_of(facts, facts.faults[0].where)[0].when.at, Cycles{2'500});
}

TEST(FaultChain, BeginsWithAnErrorResponseOrWithASilentDropOfTheServos) {
  RunFacts facts;
  facts.injected_faults = {injected_at(2'000, BlockHang{.clock = ClockGroup::kEncoder})};
  facts.controller_silent = true;
  facts.servo_off_at = RunPlace{.tick = 5, .at = Cycles{12'500}};
  EXPECT_EQ(first_fault_text(facts),
            "the servo enables dropped without a report at tick 5: block_hang of clock encoder at cycle 2000");
  facts.bus_aborts = {{.core = 0,
                       .write = false,
                       .address = 0x43C20010,
                       .error = BusError::kSlaveError,
                       .where = {.tick = 1, .at = Cycles{2'600}}}};
  EXPECT_EQ(first_fault_text(facts),
            "core 0 stopped: read of 0x43C20010 answered SLVERR at tick 1: block_hang of clock encoder at cycle 2000");
  facts.faults = {reported(FaultCause::kDrivesOff, 0, 1'000)};
  EXPECT_EQ(first_fault(facts)->what, FirstFault::What::kBusError) << "drives that are off are no fault";
}

}  // namespace
}  // namespace armature::cosim
