#include "cosim/scenario/files/mesh_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/files/robot_loader.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPart =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";

class MeshFiles : public testing::Test {
 protected:
  // A shipped robot with these keys in [meshes].
  RobotSpec load(const std::string& meshes) {
    const std::string text = test::read_file(fs::path{ARMATURE_SOURCE_DIR} / "scenarios/robots/vo2021_6r.toml");
    RobotSpec robot = load_robot(folder_.write("vo2021_6r.toml", text + "\n[meshes]\n" + meshes), problems_);
    for (const Problem& problem : problems_) {
      std::string line = problem.text();
      for (const std::string folder = folder_.path().string() + "/"; line.find(folder) != std::string::npos;) {
        line.erase(line.find(folder), folder.size());
      }
      texts_ += line.substr(line.find(' ') + 1) + "\n";
    }
    return robot;
  }

  test::TempFolder folder_;
  std::vector<Problem> problems_;
  std::string texts_;  // of the problems, without their files
};

TEST_F(MeshFiles, AreInputsOfTheRobot) {
  folder_.write("base.stl", kPart);
  folder_.write("link.stl", kPart);
  const RobotSpec robot = load("base = \"base.stl\"\nlinks = [\"link.stl\", \"\", \"link.stl\", \"\", \"\", \"\"]\n");
  EXPECT_EQ(texts_, "");
  EXPECT_EQ(robot.meshes.base, (folder_.path() / "base.stl").string());
  ASSERT_EQ(robot.meshes.links.size(), 6u);
  EXPECT_EQ(robot.meshes.links[2], (folder_.path() / "link.stl").string());
  EXPECT_EQ(robot.meshes.links[1], "");
  ASSERT_EQ(robot.mesh_files.size(), 2u);  // each once
  EXPECT_EQ(robot.mesh_files[1].file, robot.meshes.links[0]);
  EXPECT_EQ(robot.mesh_files[1].sha256, sha256_hex(kPart));
}

TEST_F(MeshFiles, AreOneForEachJoint) {
  load("links = [\"a.stl\", \"b.stl\"]\n");
  EXPECT_EQ(texts_, "meshes.links: expected 6 names, one for each joint, found 2\n");
}

TEST_F(MeshFiles, ThatAreMissingAreNamed) {
  folder_.write("link.stl", kPart);
  load("base = \"bsae.stl\"\nlinks = [\"link.stl\", \"\", \"lnik.stl\", \"\", \"\", \"\"]\n");
  EXPECT_EQ(texts_, "meshes.base: no such file: bsae.stl\nmeshes.links: no such file: lnik.stl\n");
}

TEST_F(MeshFiles, ReportMistakesInTheFiles) {
  folder_.write("base.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 ten\n");
  folder_.write("link.stl", "o part\nv 0 0 0\n");
  load("base = \"base.stl\"\nlinks = [\"link.stl\", \"\", \"\", \"\", \"\", \"\"]\n");
  EXPECT_EQ(texts_,
            "expected a number from -100000 to 100000 (mm), found \"ten\"\n"
            "is no STL file: it is neither binary nor does it begin with \"solid\"\n");
  EXPECT_EQ(problems_[0].origin.line, 4);
}

TEST_F(MeshFiles, NeedKinematics) {
  const fs::path file = folder_.write("joints.toml",
                                      "name = \"joints\"\nplant = \"ideal\"\naxis = [{}, {}, {}, {}, {}, {}]\n"
                                      "[defaults]\nmin_deg = -90\nmax_deg = 90\nmax_speed_deg_s = 120\n"
                                      "max_accel_deg_s2 = 600\n[meshes]\nbase = \"base.stl\"\n");
  std::vector<Problem> problems;
  static_cast<void>(load_robot(file, problems));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].key, "meshes.base");
  EXPECT_EQ(problems[0].message, "needs [kinematics], which moves the parts");
}

}  // namespace
}  // namespace armature::cosim
