// The files of bad_input/scenario and bad_input/robot, one for each table, hold mistakes with their expected messages.
// bad_input/README.md describes them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path{ARMATURE_SOURCE_DIR} / "tests/cosim/bad_input";
constexpr std::string_view kTitle = "#=== ";
constexpr std::string_view kMark = "#! ";

// One document that the loader refuses. `text` has as many empty lines in front as the file has lines before it, so
// that the problems have the lines of the file.
struct Case {
  std::string title;
  std::string text;
  std::vector<std::string> expected;  // `LINE:COLUMN: key: message`, or with the name of another file in front
};

// The problem of a mark on `line`: a number and a colon in front are a column, two of them line and column.
std::string expected_problem(std::string_view note, std::size_t line) {
  const std::size_t digits = note.find_first_not_of("0123456789");
  const bool column_alone = digits > 0 && note.substr(digits).starts_with(": ");
  return (column_alone ? std::to_string(line) + ":" : std::string{}) + std::string{note};
}

std::vector<Case> cases_of(const fs::path& file) {
  std::vector<Case> cases;
  std::ifstream stream{file};
  std::size_t line = 0;
  std::size_t noted = 0;  // the line that a mark on a line of its own belongs to
  for (std::string text; std::getline(stream, text);) {
    ++line;
    if (text.starts_with(kTitle)) {
      cases.push_back({text.substr(kTitle.size()), std::string(line, '\n'), {}});
      continue;
    }
    if (cases.empty()) continue;
    cases.back().text += text + "\n";
    const std::size_t mark = text.find(kMark);
    if (mark != 0) noted = line;
    if (mark != std::string::npos) {
      cases.back().expected.push_back(expected_problem(std::string_view{text}.substr(mark + kMark.size()), noted));
    }
  }
  // The empty lines between two cases belong to neither.
  for (Case& one : cases) {
    while (one.text.ends_with("\n\n")) one.text.pop_back();
  }
  return cases;
}

// What the loader says about the file, without its name; sorted.
std::vector<std::string> problems_of(const std::string& name, bool robot) {
  std::vector<std::string> texts;
  try {
    LoadOptions options;
    options.search_path = fs::path{ARMATURE_SOURCE_DIR} / "scenarios";
    if (robot) {
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
  std::ranges::sort(texts);
  return texts;
}

// Loads every case of a folder, each from a file with the name of its table, beside a folder test_robots.
void check_folder(const std::string& kind, std::size_t at_least) {
  const test::TempFolder folder;
  fs::create_directory_symlink(kFolder / "../test_robots", folder.path() / "test_robots");
  std::size_t problems = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator{kFolder / kind}) {
    const std::string name = entry.path().filename().string();
    for (Case& one : cases_of(entry.path())) {
      SCOPED_TRACE(kind + "/" + name + ": " + one.title);
      fs::current_path(folder.write("case/" + name, one.text).parent_path());
      std::ranges::sort(one.expected);
      EXPECT_FALSE(one.expected.empty());
      EXPECT_EQ(problems_of(name, kind == "robot"), one.expected);
      problems += one.expected.size();
    }
  }
  fs::current_path(kFolder);
  EXPECT_GE(problems, at_least) << "cases are lost";
}

TEST(BadInput, EveryScenarioIsRefusedWithExactlyItsProblems) {
  check_folder("scenario", 350);
}

TEST(BadInput, EveryRobotIsRefusedWithExactlyItsProblems) {
  check_folder("robot", 70);
}

}  // namespace
}  // namespace armature::cosim
