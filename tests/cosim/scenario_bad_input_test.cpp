// Every file of bad_input/ begins with the complete list of its problems, one `# expect: LINE:COLUMN: key: message`
// each (with the file's name in front when the problem is in another file).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cosim/scenario/robot_loader.hpp"
#include "cosim/scenario/scenario_loader.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path{ARMATURE_SOURCE_DIR} / "tests/cosim/bad_input";

std::vector<std::string> expected_problems(const fs::path& file) {
  const std::string mark = "# expect: ";
  std::vector<std::string> expected;
  std::ifstream stream{file};
  for (std::string line; std::getline(stream, line) && line.starts_with(mark);) {
    expected.push_back(line.substr(mark.size()));
  }
  return expected;
}

std::vector<std::string> problems_of(const std::string& name) {
  std::vector<std::string> texts;
  try {
    LoadOptions options;
    options.search_path = fs::path{ARMATURE_SOURCE_DIR} / "scenarios";
    if (name.starts_with("robot_")) {
      (void)load_robot(name);
    } else {
      (void)load_scenario(name, options);
    }
  } catch (const InputError& error) {
    const std::string own = name + ":";
    for (const Problem& problem : error.problems()) {
      const std::string text = problem.text();
      texts.push_back(text.starts_with(own) ? text.substr(own.size()) : text);
    }
  }
  return texts;
}

TEST(BadInput, EveryFileIsRefusedWithExactlyItsProblems) {
  fs::current_path(kFolder);
  int scenarios = 0;
  int robots = 0;
  std::vector<fs::path> files{fs::directory_iterator{kFolder}, {}};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const std::string name = file.filename().string();
    SCOPED_TRACE(name);
    name.starts_with("robot_") ? ++robots : ++scenarios;
    const std::vector<std::string> expected = expected_problems(file);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(problems_of(name), expected);
  }
  EXPECT_GE(scenarios, 40);
  EXPECT_GE(robots, 20);
}

}  // namespace
}  // namespace armature::cosim
