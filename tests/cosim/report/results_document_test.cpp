// scenarios/RESULTS.md against what is written: columns, words and keys cannot be missing or stale. The tables of facts
// are generated; the test keys.fresh compares them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cosim/golden/golden.hpp"
#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/scenario/kinds.hpp"
#include "cosim/serial/serial_log.hpp"
#include "cosim/text/names.hpp"
#include "cosim/trace/columns.hpp"
#include "cosim/trace/load_writer.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

struct Row {
  std::string section;             // heading of ##
  std::string subsection;          // heading of ###, without its backticks
  std::string table;               // the first word of the header of its table
  std::vector<std::string> names;  // in backticks in the first cell
};

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t begin = text.find('`'); begin != std::string::npos; begin = text.find('`', begin)) {
    const std::size_t end = text.find('`', begin + 1);
    if (end == std::string::npos) break;
    names.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end + 1;
  }
  return names;
}

std::string document() {
  return test::read_file(std::string{ARMATURE_SOURCE_DIR} + "/scenarios/RESULTS.md");
}

std::vector<Row> table_rows() {
  std::istringstream text{document()};
  std::vector<Row> rows;
  Row at;
  bool in_table = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("## ")) at.section = line.substr(3), at.subsection.clear();
    if (line.starts_with("### ")) at.subsection = names_in(line).at(0);
    if (!line.starts_with('|')) {
      in_table = false;
      continue;
    }
    const std::string cell = line.substr(2, line.find(" |", 1) - 2);
    if (!in_table) {
      at.table = cell;
      in_table = true;
    } else if (!line.starts_with("|---")) {
      Row row = at;
      row.names = names_in(cell);
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<std::string> documented(const std::string& section, const std::string& table) {
  std::vector<std::string> names;
  for (const Row& row : table_rows()) {
    if (row.section == section && row.table == table) names.insert(names.end(), row.names.begin(), row.names.end());
  }
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

TEST(ResultsDocument, HasTheColumnsOfATraceInTheirOrder) {
  std::vector<std::string> columns;
  for (const std::string& name : documented("trace.csv and golden.csv", "column")) {
    if (!name.starts_with("jN_")) {
      columns.push_back(name);
      continue;
    }
    for (std::size_t axis = 1; axis <= kAxes; ++axis) columns.push_back("j" + std::to_string(axis) + name.substr(2));
  }
  EXPECT_EQ(joined(columns), trace_header(ToolColumns::kYes));
}

TEST(ResultsDocument, HasTheIntervalOfTheRowsOfAGolden) {
  EXPECT_THAT(document(), testing::HasSubstr("golden.csv for\nevery " + std::to_string(kGoldenEveryTicks) + "th."));
}

TEST(ResultsDocument, HasTheWordsOfEveryState) {
  const std::vector<std::string> words = documented("trace.csv and golden.csv", "`state`");
  EXPECT_THAT(words, testing::UnorderedElementsAreArray(kWordsOf<MotionState>));
}

TEST(ResultsDocument, HasTheColumnsOfTheLoadOfTheCores) {
  EXPECT_EQ(joined(documented("load.csv", "column")), std::string{kLoadHeader} + "," + kInstructionColumns);
}

TEST(ResultsDocument, HasTheColumnsOfTheSerialLog) {
  EXPECT_EQ(joined(documented("serial.csv", "column")), kSerialLogHeader);
}

// Everything that a summary can hold.
RunSummary everything() {
  RunSummary summary;
  summary.sources = {{"f", "0"}};
  summary.variant = Variant::kPaper;
  summary.arm.kinematics = KinematicsSpec{.family = std::string{kSixRFamily}};
  summary.frames.emplace_back();
  summary.expect_results = {{"underruns", "0", "5"}};
  summary.expect_failures = {{"underruns", "0", "5"}};
  summary.moment_wave.emplace();
  RunFacts& facts = summary.facts;
  facts.faults.push_back({FaultCause::kEncoder, {.tick = 0, .at = Cycles{1}, .axis = 1}});
  for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
    const FaultKind kind = Kind{};
    facts.injected_faults.emplace_back().spec.kind = kind;
    facts.injected_faults.back().fault = facts.faults.front();
  });
  facts.inputs.emplace_back();
  facts.bus_aborts.emplace_back();
  MoveStarted arc;
  arc.kind = MoveKind::kArc;
  arc.path.shape = PositionPath::Shape::kArc;
  arc.path.advance_mm = 1;
  arc.on_conveyor = true;
  arc.unasked_stop = true;
  arc.rapid = true;
  MoveStarted spline;
  spline.kind = MoveKind::kSpline;
  spline.path.shape = PositionPath::Shape::kSpline;
  facts.moves = {MoveStarted{}, arc, spline};
  facts.taken_ticks.resize(3);
  facts.jogs.emplace_back();
  facts.homings.emplace_back();
  facts.refusals = {{{.reason = Refusal::kSingular, .path = {.kind = PathProblem::Kind::kTooFast}}, Cycles{7}},
                    {{.reason = Refusal::kOutsideLimits}, Cycles{7}}};
  facts.path_error = facts.command_path_error = PathDeviation{};
  Scenario scenario;
  scenario.program_files.emplace_back();
  facts.names = CommandNames{scenario};
  facts.program_events.emplace_back();
  facts.serial_sent = "x";
  facts.most_instructions_at = RunPlace{};
  facts.outputs = {{.pin = 1, .level = true, .at = Cycles{1}}};
  return summary;
}

void add_keys(const nlohmann::json& json, const std::string& path, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    const std::string full = path.empty() ? key : path + "." + key;
    if (value.is_object()) {
      add_keys(value, full, keys);
    } else if (value.is_array() && !value.empty() && value[0].is_object()) {
      for (const auto& element : value) add_keys(element, full + "[]", keys);
    } else {
      keys.insert(full);
    }
  }
}

// Whether an object, or an array of objects, has a section of its own.
bool has_section(const std::string& key) {
  return std::ranges::any_of(table_rows(), [&](const Row& row) {
    return row.section == "summary.json" && (row.subsection == key || row.subsection == key + "[]");
  });
}

TEST(ResultsDocument, HasEveryKeyOfASummaryAndNoOther) {
  std::set<std::string> written;
  add_keys(nlohmann::json::parse(summary_json(everything())), "", written);
  std::set<std::string> documented_keys;
  for (const Row& row : table_rows()) {
    if (row.section != "summary.json") continue;
    for (const std::string& name : row.names) {
      if (has_section(row.subsection + "." + name)) continue;  // its own keys are
      EXPECT_TRUE(documented_keys.insert(row.subsection.empty() ? name : row.subsection + "." + name).second) << name;
    }
  }
  EXPECT_THAT(documented_keys, testing::ContainerEq(written));
}

}  // namespace
}  // namespace armature::cosim
