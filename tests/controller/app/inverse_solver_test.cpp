// The inverse kinematics of the whole controller, solved elsewhere.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "controller/host_memory/wire.hpp"
#include "controller/kinematics/inverse_solver.hpp"
#include "controller/kinematics/six_r.hpp"
#include "tests/controller/support/cartesian_moves.hpp"

namespace armature {
namespace {

using test::ControllerMains;
using test::ControllerRig;
using test::kPostureDeg;
using test::kThere;

// Where the solver of a core is: it looks at the clock of that core, as one does that waits for the bus.
class Delegate final : public InverseSolver {
 public:
  struct Record {
    std::vector<Theta> tracked;
    int others = 0;
    Cycles latest{-1};
  };
  Delegate(const ArmGeometry& geometry, RegisterBus& bus, Record& record)
      : six_r_{geometry}, bus_{bus}, record_{record} {}

  RawTracking track(const Transform& base_T_flange, const Theta& previous, double wrist_zone,
                    bool keep_elbow) noexcept override {
    wait();
    const RawTracking found = six_r_.track(base_T_flange, previous, wrist_zone, keep_elbow);
    record_.tracked.push_back(found.theta);
    return found;
  }
  RawTracking track_point(const Eigen::Vector3d& point_mm, const Eigen::Vector3d& flange_p_mm,
                          const Theta& previous) noexcept override {
    wait();
    ++record_.others;
    return six_r_.track_point(point_mm, flange_p_mm, previous);
  }
  RawSolutions inverse(const Transform& base_T_flange, const Theta& previous) noexcept override {
    wait();
    ++record_.others;
    return six_r_.inverse(base_T_flange, previous);
  }

 private:
  void wait() {
    const Cycles now = bus_.now();
    EXPECT_GE(now, std::exchange(record_.latest, now));
  }

  SixR six_r_;
  RegisterBus& bus_;
  Record& record_;
};

class InverseSolverTest : public test::CartesianMovesTest {
 protected:
  // The controller of `delegated`, whose cores ask their delegates.
  ControllerMains start(host_memory::HostMemory& memory) {
    controller_ = std::make_unique<Controller>(memory);
    return {.core0 =
                [this](RegisterBus& bus) {
                  Delegate solver{rig.robot.arm, bus, core0};
                  controller_->core0_main(bus, &solver);
                },
            .core1 =
                [this](RegisterBus& bus) {
                  Delegate solver{rig.robot.arm, bus, core1};
                  controller_->core1_main(bus, &solver);
                }};
  }
  [[nodiscard]] JointAngles joints_of(const Theta& theta) const {
    const ArmGeometry& arm = rig.robot.arm;
    return make_per_axis(
        [&](std::size_t axis) { return Radians{arm.sign[axis] * (theta[axis] - arm.offset_rad[axis])}; });
  }
  void expect_equal_bytes() {
    ASSERT_EQ(rig.rows.size(), delegated.rows.size());
    for (std::size_t i = 0; i < rig.rows.size(); ++i) {
      host_memory::Block<Telemetry> software{}, elsewhere{};
      host_memory::put(software.data(), 0, rig.rows[i]);
      host_memory::put(elsewhere.data(), 0, delegated.rows[i]);
      ASSERT_EQ(software, elsewhere) << "tick " << i;
    }
    EXPECT_EQ(std::memcmp(&rig.memory(), &delegated.memory(), rig.memory().bytes), 0);
  }

  Delegate::Record core0, core1;

 private:
  std::unique_ptr<Controller> controller_;

 public:
  ControllerRig delegated{
      test::irb120(), config(), {}, [this](host_memory::HostMemory& memory) { return start(memory); }};
};

TEST_F(InverseSolverTest, EverySetPointOfAPathComesFromIt) {
  delegated.move_at(0, kPostureDeg);
  for (ControllerRig* on : {&rig, &delegated}) {
    on->submit_at(kThere, shift(30, 0, 0));
    on->run(kThere + 12'000);
  }
  expect_equal_bytes();
  ASSERT_EQ(delegated.moves_finished(), 2);
  // The last one is the end of the plan.
  const MoveStarted& line = delegated.moves[1];
  const auto solved = static_cast<std::size_t>(line.duration.value()) - 1;
  ASSERT_EQ(core0.tracked.size(), solved);
  for (std::size_t i = 0; i < solved; ++i) {
    const JointAngles& reference = delegated.row(line.start_tick.value() + static_cast<std::int64_t>(i)).reference;
    ASSERT_EQ(reference, joints_of(core0.tracked[i])) << "tick " << i << " of the path";
  }
  EXPECT_GE(core1.tracked.size(), 100u);  // samples of the path for its law and its check
}

TEST_F(InverseSolverTest, SolvesWhateverTheControllerAsks) {
  delegated.move_at(0, kPostureDeg);
  for (ControllerRig* on : {&rig, &delegated}) {
    on->at(kThere, [on] {
      on->submit(shift(30, 0, 0, 5.0));
      on->submit(shift(0, 30, 0, 5.0));
      on->submit(PoseMove{.target = {.frame = kToolFrame, .position_mm = {0, 0, 20}}});
    });
    on->submit_at(kThere + 30'000, Jog{.kind = Jog::Kind::kTool,
                                       .move_mm_s = {0, 40, 0},
                                       .duration = Ticks{3'000},
                                       .tool = {.accel_mm_s2 = 200.0, .turn_accel_rad_s2 = 2.0}});
    on->run(kThere + 40'000);
    EXPECT_TRUE(on->refusals.empty());
    EXPECT_EQ(on->moves_finished(), 4);
    EXPECT_EQ(on->jogs_ended.size(), 1u);
  }
  expect_equal_bytes();
  EXPECT_GT(core0.tracked.size(), 3'000u);
  EXPECT_GT(core1.others, 0);
}

}  // namespace
}  // namespace armature
