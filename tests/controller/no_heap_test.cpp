// Counts heap allocations while the controller runs. Alone in its binary: it replaces operator new.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <new>

#include "tests/controller/controller_rig.hpp"

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
  rig.refusals.reserve(10);
  rig.move_at(2'000, {40, -30, 20, 10, -10, 30});
  rig.submit_at(4'000, Stop{});
  rig.move_at(4'001, {});
  rig.move_at(4'002, {0, 0, 999, 0, 0, 0});
  rig.at(9'000, [&] { rig.logic.alarm = 1; });
  rig.at(9'500, [&] { rig.logic.alarm = 0; });
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

}  // namespace
}  // namespace armature
