// Lines and arcs through the whole co-simulation, short enough for the sanitizers: planner and motion loop on their
// fibers, reports of moves, path error and the trace of the tool centre point.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/text/names.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

// What `armature run` collects.
class PathRecorder final : public test::SilentListener {
 public:
  PathRecorder(const Scenario& scenario, const std::filesystem::path& trace)
      : facts_{scenario.robot, 1}, tool_{scenario}, trace_{trace, 1, ToolColumns::kYes} {}

  void on_row(TraceRow& row) override {
    row.tool_point = tool_.measure(row.telemetry);
    facts_.add(row);
    digest_.add(row);
    trace_.write(row, digest_);
  }
  void on_action(const ScriptAction& action, Cycles) override {
    if (const auto* command = std::get_if<CommandSpec>(&action)) facts_.add(*command);
  }
  void on_event(const Event& event, Cycles now) override { facts_.on_event(event, now); }

  [[nodiscard]] RunFacts facts() const { return facts_.facts(); }
  void close() { trace_.close(); }

 private:
  RunFactsCollector facts_;
  ToolPointMeter tool_;
  IntegerDigest digest_;
  CsvWriter trace_;
};

constexpr double kLineMm = 1.2;
constexpr double kRadiusMm = 0.7;
constexpr double kBlendMm = 0.3;

// In the frame of the tool where the move before ends.
PathSpec path_to(std::array<double, 3> xyz_mm) {
  return {.pose = {.xyz_mm = xyz_mm, .frame = kToolFrameIndex}, .speed_mm_s = 100, .accel_mm_s2 = 10'000};
}

// 0.09 s: along x of the tool, rounded into an arc in its x-y plane that begins at an angle to it, held on the way.
Scenario line_and_arc() {
  Scenario scenario = load_scenario(test::kScenarios / "fig9_joint_move", test::shipped());
  scenario.duration_s = 0.09;
  // The arm begins with all joints at 0: let that be a posture with bent elbow and wrist.
  scenario.robot.kinematics->offset_deg = {0, 70, 30, 0, 40, 0};
  for (AxisSpec& axis : scenario.robot.axes) {
    axis.max_accel_deg_s2 = 6000;
    axis.drive.natural_hz = 400;  // settled in 7 ms
  }
  LineSpec line{.path = path_to({kLineMm, 0, 0})};
  line.path.blend_mm = kBlendMm;
  const ArcSpec arc{.path = path_to({0, 2 * kRadiusMm, 0}), .via_mm = {0.5 * kRadiusMm, kRadiusMm, 0}};
  scenario.moves = {{.at_s = 0.001, .kind = line},
                    {.at_s = 0.001, .kind = arc},
                    {.at_s = 0.018, .kind = HoldSpec{}},
                    {.at_s = 0.034, .kind = ResumeSpec{}}};
  for (std::uint32_t i = 0; i < scenario.moves.size(); ++i) scenario.moves[i].index = i;
  return scenario;
}

TEST(SimulationPath, ABlendedLineAndArcAreDrawnThroughAHold) {
  const Scenario scenario = line_and_arc();
  const test::TempFolder folder;
  PathRecorder recorder{scenario, folder.path() / "trace.csv"};
  const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), recorder});
  ASSERT_EQ(end.reason, EndReason::kFinished) << end.failure;
  recorder.close();

  const RunFacts facts = recorder.facts();
  EXPECT_EQ(facts.outcome(), kCompleted);
  EXPECT_TRUE(facts.refusals.empty());
  ASSERT_EQ(facts.moves.size(), 2u);
  EXPECT_EQ(facts.moves[0].kind, MoveKind::kLine);
  EXPECT_EQ(facts.moves[1].kind, MoveKind::kArc);
  EXPECT_EQ(facts.moves_finished, 2);
  EXPECT_EQ(facts.blended_with_next(0), true);
  EXPECT_GT(facts.held_s, 0.002);
  ASSERT_TRUE(facts.taken_ticks[0] && facts.taken_ticks[1]);
  EXPECT_GT(std::max(*facts.taken_ticks[0] - facts.moves[0].duration.value(),
                     *facts.taken_ticks[1] - facts.moves[1].duration.value()),
            40)
      << "a hold lengthens the move that it interrupts";

  // Off the two paths only in the corner.
  ASSERT_TRUE(facts.command_path_error && facts.path_error && facts.final_tcp_mm);
  EXPECT_GT(facts.command_path_error->mm, 1e-3);
  EXPECT_LT(facts.command_path_error->mm, kBlendMm);
  EXPECT_LT(facts.path_error->mm, kBlendMm);
  const Eigen::Vector3d shift = *facts.final_tcp_mm - facts.moves[0].path.start_mm;
  EXPECT_NEAR(shift.norm(), std::hypot(kLineMm, 2 * kRadiusMm), 0.01);

  const std::string trace = test::read_file(folder.path() / "trace.csv");
  EXPECT_THAT(trace.substr(0, trace.find('\n')), testing::HasSubstr("tcp_enc_z_mm"));
  EXPECT_EQ(std::ranges::count(trace, '\n'), facts.ticks + 1);
}

}  // namespace
}  // namespace armature::cosim
