// Counts heap allocations while the controller runs. Alone in its binary: it replaces operator new.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <new>

#include "controller/app/inverse_console.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace {

std::int64_t allocations = 0;

void* allocate(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc{};
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace armature {
namespace {

TEST(NoHeap, TheCounterCounts) {
  const std::int64_t before = allocations;
  ::operator delete(::operator new(1));  // unlike an expression with new, never optimised away
  EXPECT_EQ(allocations, before + 1);
}

TEST(NoHeap, MovesStopsAndFaultsIn12000TicksAllocateNothing) {
  test::ControllerRig rig;
  rig.moves.reserve(10);
  rig.faults.reserve(10);
  rig.finished.reserve(10);
  rig.faults_cleared.reserve(10);
  rig.refusals.reserve(10);
  rig.move_at(2'000, {40, -30, 20, 10, -10, 30});
  rig.submit_at(4'000, Stop{});
  rig.move_at(4'001, {});
  rig.move_at(4'002, {0, 0, 999, 0, 0, 0});
  rig.at(9'000, [&] { rig.logic.pins.drive_alarm = 1; });
  rig.at(9'500, [&] { rig.logic.pins.drive_alarm = 0; });
  rig.submit_at(9'600, ClearFault{});
  rig.move_at(9'700, {5, 0, 0, 0, 0, 0});
  rig.at(6'000, [&] { rig.logic.drives[2].lose = 50; });
  std::int64_t before = 0, after = 0;
  rig.at(1'000, [&] { before = allocations; });
  rig.at(13'000, [&] { after = allocations; });
  rig.run(13'010);
  EXPECT_EQ(after - before, 0);
  EXPECT_GE(rig.moves.size(), 3u);
  EXPECT_EQ(rig.refusals.size(), 1u);
  EXPECT_EQ(rig.faults.size(), 1u);
}

TEST(NoHeap, PlanningAndDrivingAChainWithAHoldAllocatesNothing) {
  test::ControllerRig rig{test::irb120()};
  rig.moves.reserve(10);
  rig.finished.reserve(10);
  rig.refusals.reserve(10);
  const auto shift = [](double x_mm, double z_mm, double blend_mm) {
    return CartesianMove{
        .target = {.frame = kToolFrame, .position_mm = {x_mm, 0, z_mm}}, .limits = test::kGentle, .blend_mm = blend_mm};
  };
  rig.move_at(0, {10, 20, 10, 5, 40, -20});
  rig.submit_at(8'000, shift(30, 0, 5));
  rig.submit_at(8'000, shift(0, 30, 5));
  rig.submit_at(8'000, shift(0, 9'000, 5));  // refuses the three
  rig.submit_at(9'000, shift(30, 0, 5));
  rig.submit_at(9'000, shift(0, 30, 5));
  rig.submit_at(9'000, PoseMove{.target = {.frame = kToolFrame, .position_mm = {0, 10, 0}}});
  rig.submit_at(12'000, Hold{});
  rig.submit_at(14'000, SetOverride{0.5});
  rig.submit_at(15'000, Resume{});
  std::int64_t before = 0, after = 0;
  rig.at(7'000, [&] { before = allocations; });
  rig.at(50'000, [&] { after = allocations; });
  rig.run(50'010);
  EXPECT_EQ(after - before, 0);
  EXPECT_EQ(rig.moves_finished(), 4);
  EXPECT_TRUE(rig.moves[3].continues);  // from a path into a joint move
  EXPECT_EQ(rig.refusals.size(), 3u);
}

TEST(NoHeap, APoseOnTheConsoleAllocatesNothing) {
  struct ReadyBus final : RegisterBus {
    std::uint32_t read32(RegAddr) noexcept override { return 0x60; }
    void write32(RegAddr, std::uint32_t) noexcept override { ++writes; }
    Interrupts wait_for_interrupt(Interrupts mask) noexcept override { return mask; }
    void send_event() noexcept override {}
    Cycles now() noexcept override { return {}; }
    void charge(Work, std::int64_t) noexcept override {}
    int writes = 0;
  } bus;
  const RobotModel robot = test::irb120();
  const Arm arm{robot};
  const InverseTask task{.base_T_flange = {.position_mm = {300, 50, 400}}};
  const std::int64_t before = allocations;
  InverseConsole{arm, robot.axis_count, task, bus}.run();
  EXPECT_EQ(allocations, before);
  EXPECT_GT(bus.writes, 800);  // characters
}

}  // namespace
}  // namespace armature
