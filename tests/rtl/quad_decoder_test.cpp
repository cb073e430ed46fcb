// quad_decoder against Table 1 of Vo 2021, all 16 transitions on every axis.
#include <cstdint>

#include "Vquad_decoder.h"
#include "tests/support/verilated_test.hpp"

namespace armature::test {
namespace {

constexpr int kAxes = 6;

struct Row {
  int a_prev, b_prev, a_new, b_new, move;
};

// As printed: first four rows increase, last four decrease.
constexpr Row kTable1[] = {{0, 0, 1, 0, +1}, {1, 0, 1, 1, +1}, {1, 1, 0, 1, +1}, {0, 1, 0, 0, +1},
                           {0, 0, 0, 1, -1}, {0, 1, 1, 1, -1}, {1, 1, 1, 0, -1}, {1, 0, 0, 0, -1}};

struct Meaning {
  int move = 0;
  bool illegal = false;
};

Meaning meaning_of(int from, int to) {
  for (const Row& row : kTable1) {
    if (from == (row.a_prev << 1 | row.b_prev) && to == (row.a_new << 1 | row.b_new)) return {row.move, false};
  }
  return {0, from != to};  // not in the table: at rest, or both lines changed
}

class QuadDecoder : public VerilatedTest<Vquad_decoder> {
 protected:
  QuadDecoder() {
    dut_.a_i = dut_.b_i = 0;
    dut_.known_i = 0x3F;
    reset();
  }

  // State of an axis: A in bit 1, B in bit 0.
  void drive(int axis, int state) {
    const auto put = [axis](std::uint8_t word, int level) {
      return static_cast<std::uint8_t>((word & ~(1 << axis)) | level << axis);
    };
    dut_.a_i = put(dut_.a_i, state >> 1 & 1);
    dut_.b_i = put(dut_.b_i, state & 1);
    dut_.eval();
  }

  void expect(int axis, Meaning meaning) {
    const int bit = 1 << axis;
    EXPECT_EQ(dut_.up_o & bit, meaning.move > 0 ? bit : 0);
    EXPECT_EQ(dut_.down_o & bit, meaning.move < 0 ? bit : 0);
    EXPECT_EQ(dut_.illegal_o & bit, meaning.illegal ? bit : 0);
  }
};

TEST_F(QuadDecoder, MovesAsTable1SaysForAllSixteenTransitions) {
  for (int axis = 0; axis < kAxes; ++axis) {
    for (int from = 0; from < 4; ++from) {
      for (int to = 0; to < 4; ++to) {
        SCOPED_TRACE(testing::Message() << "axis " << axis + 1 << " " << from << " -> " << to);
        drive(axis, from);
        tick();
        drive(axis, to);
        expect(axis, meaning_of(from, to));
        for (int other = 0; other < kAxes; ++other) {
          if (other != axis) expect(other, {});
        }
        tick();
        expect(axis, {});  // a step lasts one cycle
      }
    }
  }
}

TEST_F(QuadDecoder, DecodesAllAxesInTheSameCycle) {
  for (int shift = 0; shift < 256; ++shift) {
    int from[kAxes], to[kAxes];
    for (int axis = 0; axis < kAxes; ++axis) {
      from[axis] = (shift + axis) & 3;
      to[axis] = (shift / 4 * (axis + 1) + axis) & 3;
      drive(axis, from[axis]);
    }
    tick();
    for (int axis = 0; axis < kAxes; ++axis) drive(axis, to[axis]);
    for (int axis = 0; axis < kAxes; ++axis) expect(axis, meaning_of(from[axis], to[axis]));
    tick();
  }
}

TEST_F(QuadDecoder, OnlyFollowsWhileALevelIsUnknown) {
  dut_.known_i = 0;
  for (int to = 0; to < 4; ++to) {
    drive(2, to);
    expect(2, {});
    tick();
  }
  dut_.known_i = 0x3F;
  dut_.eval();
  expect(2, {});
  drive(2, 1);  // from 3, where it was left
  expect(2, meaning_of(3, 1));
}

}  // namespace
}  // namespace armature::test
