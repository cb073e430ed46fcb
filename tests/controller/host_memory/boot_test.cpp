// What the controller starts with: it comes back as the host wrote it, and each wrong value is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "controller/host_memory/boot_memory.hpp"
#include "controller/host_memory/boot_reader.hpp"
#include "controller/host_memory/host_side.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::host_memory {
namespace {

using test::irb120;

// All that can be set is set.
RobotModel full_robot() {
  RobotModel robot = irb120();
  robot.axis_count = 5;
  robot.axes[1].homing = HomingModel{.order = 2, .search_rad_s = 0.5, .latch_rad_s = 0.25, .index_rad = -1.0};
  robot.arm.sign[2] = -1.0;
  return robot;
}
BeltPolicyConfig test_policy() {
  return {.where = BeltPolicyConfig::Where::kArm, .full_mm = 1.0, .words = 2};
}
ControllerConfig full_config() {
  ControllerConfig config{
      .sync = SyncRule::kTimeScale,
      .feedback = false,
      .paper = PaperEncoders{.axis = 3, .switch_every = Ticks{20}},
      .flange_T_tool = {.position_mm = {1, 2, 3}},
      .max_stretch = 7.5,
      .pendant = pendant::PendantConfig{.profile = pendant::Profile::kExtended},
      .conveyor = ConveyorConfig{.direction = Eigen::Vector3d::UnitY(), .to_mm = 300.0, .policy = test_policy()},
      .program_start = std::nullopt,
      .program_resumes_after = Ticks{400},
      .referenced = false};
  config.base_T_user[1] = Transform{.rotation = rotation_from_rpy(0.1, 0.2, 0.3), .position_mm = {4, 5, 6}};
  config.job.flange_T_tool[7] = Transform{.position_mm = {7, 8, 9}};
  config.job.device_pin = {1, 2, 3};
  config.gcode.frame = FrameId{2};
  config.gcode.analog[3] = {.first_pin = 9, .bits = 8, .full = 10.0};
  config.gcode.tools.set(5).set(63);
  return config;
}
const BootProgram kProgram{ProgramLanguage::kGcode,
                           {{"a.ngc", "o<b> call\nM2\n"}, {"b.ngc", "o<b> sub\no<b> endsub\n"}}};

template <class T>
Block<T> block_of(const T& value) {
  Block<T> block{};
  put(block.data(), 0, value);
  return block;
}

TEST(Boot, AllValuesComeBackAsTheyWere) {
  BootMemory boot{full_robot(), full_config(), kProgram};
  const BootReader reader{boot.memory()};
  EXPECT_EQ(HostSide{boot.memory()}.boot_problem(), nullptr);
  ASSERT_TRUE(reader.good());
  EXPECT_EQ(block_of(reader.robot()), block_of(full_robot()));
  EXPECT_EQ(block_of(reader.config()), block_of(full_config()));
  EXPECT_EQ(reader.config().gcode.tools, full_config().gcode.tools);
  EXPECT_FALSE(reader.config().program_start);
  EXPECT_EQ(reader.config().base_T_user[1]->position_mm, Eigen::Vector3d(4, 5, 6));
  const ProgramFiles& files = reader.files();
  EXPECT_EQ(files.language, ProgramLanguage::kGcode);
  ASSERT_EQ(files.count, 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(files.name(i, reader.names()), kProgram.files[i].name);
    EXPECT_EQ(files.text(i, reader.texts()), kProgram.files[i].text);
  }
}

// A simulator of instructions maps it.
TEST(Boot, TheMemoryBeginsAtAPageAndEndsInOne) {
  for (const std::size_t size : {0u, 1u, 4095u, 4096u, 100'000u}) {
    BootMemory boot{full_robot(), full_config(), {ProgramLanguage::kGcode, {{"a", std::string(size, '%')}}}};
    EXPECT_EQ(std::bit_cast<std::uintptr_t>(&boot.memory()) % 4096, 0u);
    const std::size_t bytes = BootMemory::whole_pages(boot.memory().bytes);
    EXPECT_EQ(bytes % 4096, 0u);
    EXPECT_GE(bytes, sizeof(HostMemory) + size);
    EXPECT_LT(bytes, sizeof(HostMemory) + size + 2 * 4096);
  }
}

TEST(Boot, TheDefaultsAreAllowed) {
  BootMemory boot{RobotModel{}, ControllerConfig{}};
  const BootReader reader{boot.memory()};
  EXPECT_TRUE(reader.good());
  EXPECT_EQ(reader.files().language, ProgramLanguage::kNone);
  EXPECT_TRUE(reader.texts().empty());
}

struct Refused {
  BootProblem problem{};
  std::string value;  // the name of the member
};

template <class T>
std::string name_at(std::size_t place) {
  std::string name;
  auto find = [&](const Field& field) {
    if (!name.empty() || field.offset + field.bytes <= place) return;
    for (const NamePart* part = field.name; part->outer != nullptr; part = part->outer) {
      if (!name.empty()) name.insert(0, ".");
      name.insert(0, part->name.empty() ? std::to_string(part->index) : std::string{part->name});
    }
  };
  describe<T>(0, NamePart{}, find);
  return name;
}

// What the controller says after a change of the memory.
Refused refused_after(const std::function<void(HostMemory&)>& change) {
  BootMemory boot{full_robot(), full_config(), kProgram};
  change(boot.memory());
  const BootReader reader{boot.memory()};
  const BootReport* report = HostSide{boot.memory()}.boot_problem();
  EXPECT_EQ(reader.good(), report == nullptr);
  if (report == nullptr) return {};
  // Nothing of a wrong memory is used.
  EXPECT_EQ(block_of(reader.robot()), block_of(RobotModel{}));
  EXPECT_EQ(block_of(reader.config()), block_of(ControllerConfig{}));
  EXPECT_EQ(reader.files().count, 0u);
  const auto problem = static_cast<BootProblem>(report->problem);
  return {problem, problem == BootProblem::kRobot    ? name_at<RobotModel>(report->place)
                   : problem == BootProblem::kConfig ? name_at<ControllerConfig>(report->place)
                                                     : name_at<ProgramFiles>(report->place)};
}
void expect_refused(const std::function<void(HostMemory&)>& change, BootProblem problem, const std::string& value) {
  const Refused refused = refused_after(change);
  EXPECT_EQ(refused.problem, problem) << value;
  EXPECT_EQ(refused.value, value);
}

TEST(Boot, AnotherLayoutIsRefused) {
  using Change = void (*)(HostMemory&);
  for (const Change change : std::initializer_list<Change>{[](HostMemory& memory) { memory.magic = 0; },
                                                           [](HostMemory& memory) { ++memory.layout; },
                                                           [](HostMemory& memory) { memory.bytes = 100; }}) {
    EXPECT_EQ(refused_after(change).problem, BootProblem::kOtherLayout);
  }
}

// Each byte of a block that is neither a number nor a character has values that are no flag and no enumerator.
template <class T>
int count_words_refused(Block<T> HostMemory::*block, BootProblem problem) {
  int refused = 0;
  auto spoil = [&](const Field& field) {
    if (field.type != "flag" && field.words.empty()) return;
    const Refused found = refused_after([&](HostMemory& memory) { (memory.*block)[field.offset] = 0xFF; });
    refused += found.problem == problem && name_at<T>(field.offset) == found.value ? 1 : 0;
    if (found.problem != problem) ADD_FAILURE() << name_at<T>(field.offset);
  };
  describe<T>(0, NamePart{}, spoil);
  return refused;
}
TEST(Boot, ABadFlagOrEnumeratorIsNamed) {
  EXPECT_EQ(count_words_refused<RobotModel>(&HostMemory::robot, BootProblem::kRobot),
            2 * 6 + 1);  // index, homing; family
  // Each word that is no part of an empty optional is read: those of the frames and tools are all has_value.
  EXPECT_GT(count_words_refused<ControllerConfig>(&HostMemory::config, BootProblem::kConfig), 17 + 64 + 8);
  EXPECT_EQ(count_words_refused<ProgramFiles>(&HostMemory::program, BootProblem::kProgram), 1);  // language
}

TEST(Boot, AValueThatIsNotAllowedIsNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  using Spoil = std::pair<void (*)(RobotModel&), const char*>;
  const std::vector<Spoil> robots{
      {[](RobotModel& robot) { robot.axes[2].gear_ratio = 0.0; }, "axes.2.gear_ratio"},
      {[](RobotModel& robot) { robot.axes[5].max_speed_rad_s = kNan; }, "axes.5.max_speed_rad_s"},
      {[](RobotModel& robot) { robot.axes[0].max_rad = -9.0; }, "axes.0.max_rad"},
      {[](RobotModel& robot) { robot.axes[0].counts_per_rev = -1; }, "axes.0.counts_per_rev"},
      {[](RobotModel& robot) { robot.axes[3].dir_hold_cycles = 1024; }, "axes.3.dir_hold_cycles"},
      {[](RobotModel& robot) { robot.axes[1].homing->direction = 0.5; }, "axes.1.homing.direction"},
      {[](RobotModel& robot) { robot.axis_count = 7; }, "axis_count"},
      {[](RobotModel& robot) { robot.axis_count = 0; }, "axis_count"},
      {[](RobotModel& robot) { robot.arm.a2_mm = 0.0; }, "arm.a2_mm"},
      {[](RobotModel& robot) { robot.arm.sign[4] = 0.0; }, "arm.sign"},
  };
  for (const auto& [spoil, name] : robots) {
    RobotModel robot = full_robot();
    spoil(robot);
    expect_refused([&](HostMemory& memory) { memory.robot = block_of(robot); }, BootProblem::kRobot, name);
  }

  using SpoilConfig = std::pair<void (*)(ControllerConfig&), const char*>;
  const std::vector<SpoilConfig> configs{
      {[](ControllerConfig& config) { config.paper->axis = 6; }, "paper.axis"},
      {[](ControllerConfig& config) { config.paper->switch_every = Ticks{1}; }, "paper.switch_every"},
      {[](ControllerConfig& config) { config.flange_T_tool.rotation *= 2.0; }, "flange_T_tool.rotation"},
      {[](ControllerConfig& config) { config.base_T_user[1]->position_mm.y() = kNan; }, "base_T_user.1.position_mm"},
      {[](ControllerConfig& config) { config.max_stretch = 0.5; }, "max_stretch"},
      {[](ControllerConfig& config) { config.cordic = true; }, "cordic"},  // not with `paper`
      {[](ControllerConfig& config) { config.conveyor->to_mm = -1.0; }, "conveyor.to_mm"},
      {[](ControllerConfig& config) { config.conveyor->direction.x() = 1.0; }, "conveyor.direction"},
      // The logic of `paper` has no network.
      {[](ControllerConfig& config) { config.conveyor->policy->where = BeltPolicyConfig::Where::kLogic; },
       "conveyor.has_value"},
      {[](ControllerConfig& config) { config.conveyor->policy->words = 0; }, "conveyor.policy.words"},
      {[](ControllerConfig& config) { config.conveyor->policy->words = 257; }, "conveyor.policy.words"},
      {[](ControllerConfig& config) { config.conveyor->policy->share = 128; }, "conveyor.policy.share"},
      {[](ControllerConfig& config) { config.conveyor->policy->inputs[3].high = -2.0; },
       "conveyor.policy.inputs.3.high"},
      {[](ControllerConfig& config) { config.conveyor->policy->full_mm = 0.0; }, "conveyor.policy.full_mm"},
      {[](ControllerConfig& config) { config.job.device_pin[1] = 17; }, "job.device_pin"},
      {[](ControllerConfig& config) { config.job.accel_mm_s2 = 0.0; }, "job.accel_mm_s2"},
      {[](ControllerConfig& config) { config.gcode.analog[3].first_pin = 10; }, "gcode.analog.3.bits"},
      {[](ControllerConfig& config) { config.gcode.frame = kConveyorFrame; }, "gcode.frame.index"},
      {[](ControllerConfig& config) { config.gcode.frame = FrameId{1}; }, "gcode.frame.index"},  // is not defined
      {[](ControllerConfig& config) { config.program_start = Ticks{-1}; }, "program_start.has_value"},
      {[](ControllerConfig& config) { config.inverse = InverseTask{}; }, "inverse.has_value"},  // not with a pendant
      {[](ControllerConfig& config) { config.inverse = InverseTask{.baud = 921'600}; }, "inverse.baud"},
      {[](ControllerConfig& config) { config.inverse.emplace().base_T_flange.rotation *= 2.0; },
       "inverse.base_T_flange.rotation"},
  };
  for (const auto& [spoil, name] : configs) {
    ControllerConfig config = full_config();
    spoil(config);
    expect_refused([&](HostMemory& memory) { memory.config = block_of(config); }, BootProblem::kConfig, name);
  }

  using SpoilFiles = std::pair<void (*)(ProgramFiles&), const char*>;
  const std::vector<SpoilFiles> programs{
      {[](ProgramFiles& files) { files.count = ProgramFiles::kMax + 1; }, "count"},
      {[](ProgramFiles& files) { files.count = 0; }, "count"},
      {[](ProgramFiles& files) { files.language = ProgramLanguage::kNone; }, "count"},
      {[](ProgramFiles& files) { files.name_ends[0] = 11; }, "name_ends"},
      {[](ProgramFiles& files) { files.text_ends[0] = 1'000; }, "text_ends"},
      {[](ProgramFiles& files) { files.text_ends[1] += 8; }, "text_ends"},  // behind the end of the memory
      {[](ProgramFiles& files) { files.name_ends[1] = 0xFFFF'FFFF; }, "text_ends"},
  };
  for (const auto& [spoil, name] : programs) {
    expect_refused(
        [&spoil = spoil](HostMemory& memory) {
          ProgramFiles files;
          std::size_t at = 0;
          ASSERT_TRUE(take(memory.program.data(), at, files));
          spoil(files);
          memory.program = block_of(files);
        },
        BootProblem::kProgram, name);
  }
}

}  // namespace
}  // namespace armature::host_memory
