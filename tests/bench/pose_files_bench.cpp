// Poses a second through `armature fk` and `armature ik`, files read and written: random joints inside the limits of a
// robot file, their poses, and every solution of these. The commands run in this process, so starting a program is not
// in it; reading the robot file is. Each figure is the smallest of the rounds' processor times.
// usage: pose_files_bench [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <tuple>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/main/cli.hpp"
#include "cosim/cli/options/kinematics_io.hpp"
#include "tests/controller/support/random.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace {

using namespace armature;
using namespace armature::cosim;

constexpr std::size_t kPoses = 50'000;
constexpr std::uint64_t kSeed = 2021;
constexpr double kWantedPerSecond = 20'000;

std::string joints_file(const RobotSpec& robot) {
  armature::test::Random random{kSeed};
  std::string text;
  for (std::size_t i = 0; i < robot.axis_count; ++i) text += fmt::format("{}j{}_deg", i == 0 ? "" : ",", i + 1);
  text += '\n';
  for (std::size_t pose = 0; pose < kPoses; ++pose) {
    for (std::size_t i = 0; i < robot.axis_count; ++i) {
      const double deg = random.real(robot.axes[i].min_deg, robot.axes[i].max_deg);
      text += fmt::format("{}{}", i == 0 ? "" : ",", deg);
    }
    text += '\n';
  }
  return text;
}

double best_seconds(int rounds, const std::function<int()>& command) {
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t start = std::clock();
    if (command() != kExitOk) std::exit(EXIT_FAILURE);
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

void line(const std::string& robot, const char* command, double seconds) {
  const double rate = static_cast<double>(kPoses) / seconds;
  fmt::print("{:<18} {:<3} {:>10.0f} poses/s   {:>5.1f} times the {:.0f} wanted\n", robot, command, rate,
             rate / kWantedPerSecond, kWantedPerSecond);
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  try {
    const armature::cosim::test::TempFolder folder;
    fmt::print("{} poses, seed {}, best of {} rounds\n", kPoses, kSeed, rounds);
    for (const std::string robot : {"abb_irb120", "hu2012_5r"}) {
      const std::string file = ARMATURE_SOURCE_DIR "/scenarios/robots/" + robot + ".toml";
      const std::string joints = folder.write("joints.csv", joints_file(load_arm(file, {}).spec)).string();
      const std::string poses = (folder.path() / "poses.csv").string();
      const std::string solutions = (folder.path() / "solutions.csv").string();
      for (const auto& [command, in, out] : {std::tuple{"fk", joints, poses}, std::tuple{"ik", poses, solutions}}) {
        const std::array arguments{"armature", command,    "--robot", file.c_str(),
                                   "--in",     in.c_str(), "--out",   out.c_str()};
        line(robot, command,
             best_seconds(rounds, [&] { return cli_main(static_cast<int>(arguments.size()), arguments.data()); }));
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "pose_files_bench: {}\n", error.what());
    return EXIT_FAILURE;
  }
}
