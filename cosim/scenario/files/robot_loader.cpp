#include "cosim/scenario/files/robot_loader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "cosim/scenario/files/axis_checks.hpp"
#include "cosim/scenario/files/mesh_files.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/scenario/toml/table_reader.hpp"
#include "cosim/scenario/toml/toml_document.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/suggest.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kDefaults = "defaults";
// Required keys that neither the defaults nor any axis has are reported once, at the defaults.
void report_missing(const ConfigValue& root, std::size_t axes, const std::vector<MissingKey>& missing,
                    ProblemList& problems) {
  const ConfigEntry* defaults = root.find(kDefaults);
  std::vector<std::string_view> reported;
  for (const MissingKey& one : missing) {
    const auto count = static_cast<std::size_t>(std::ranges::count(missing, one.key, &MissingKey::key));
    if (defaults == nullptr || axes < 2 || count < axes) {
      problems.add(one.table, one.path, one.message);
    } else if (std::ranges::find(reported, one.key) == reported.end()) {
      reported.push_back(one.key);
      problems.add(defaults->value.origin, fmt::format("{}.{}", kDefaults, one.key),
                   one.message + "; it is missing in every [[axis]], too");
    }
  }
}

// The keys that an axis may lack if its motor is not known.
bool may_be_missing(const MissingKey& missing) {
  return missing.key == "gear_ratio" || missing.key == "pulses_per_rev" || missing.key == "encoder_lines";
}

// [[link]], [tool], [payload] and [axis.dynamics] belong to plant = "dynamic", which needs the first and the last.
// `bare`: those of the `axes` axes that have no dynamics.
void read_bodies(TableReader& reader, const KeyContext& context, const std::vector<std::size_t>& bare, std::size_t axes,
                 RobotSpec& robot) {
  const bool dynamic = robot.plant == kDynamicPlant;
  const std::string why = "only with plant = \"" + std::string{kDynamicPlant} + "\"";
  reader.tables(
      "link", [&](TableReader& table) { body_keys().read(table, context, robot.links.emplace_back()); }, kAxes);
  reader.table("tool", [&](TableReader& table) { body_keys().read(table, context, robot.tool); });
  reader.table("payload", [&](TableReader& table) { body_keys().read(table, context, robot.payload); });
  if (!dynamic) {
    for (const char* key : {"gravity_m_s2", "link", "tool", "payload"}) {
      if (reader.has(key)) reader.problem(key, why);
    }
    if (bare.size() < axes) reader.problem("plant", "expected \"dynamic\", because an axis has dynamics");
    return;
  }
  if (!robot.kinematics) reader.problem("plant", "needs [kinematics], which gives the frames of the links");
  if (robot.links.size() != robot.axis_count) {
    reader.problem("link", "expected " + std::to_string(robot.axis_count) + " tables [[link]], found " +
                               std::to_string(robot.links.size()));
  }
  for (const std::size_t axis : bare) {
    reader.problem("axis", element_key("axis", axis) + " has no dynamics, which plant = \"dynamic\" needs");
  }
}

// Checks that the number of tables [[axis]], `count`, fits the arm.
void check_axis_count(TableReader& reader, const RobotSpec& robot, std::size_t count) {
  if (robot.kinematics && robot.kinematics->family.empty()) return;  // not known, and reported
  if (count == robot.axis_count || (count == 0 && reader.has("axis"))) return;
  const std::string five_r = "kinematics.family = \"" + std::string{kFiveRFamily} + "\"";
  const std::string why =
      robot.axis_count == kAxes ? count == joints_of(kFiveRFamily) ? "; 5 only with " + five_r : "" : " with " + five_r;
  reader.problem("axis", "expected " + std::to_string(robot.axis_count) + " tables [[axis]]" + why + ", found " +
                             std::to_string(count));
}

}  // namespace

RobotSpec load_robot(const std::filesystem::path& file, std::vector<Problem>& all) {
  const std::string text = read_toml(file);
  const ConfigValue root = parse_toml(text, file.string());
  ProblemList problems{file.string()};
  RobotSpec robot;
  robot.source = input_file(file, text);
  TableReader reader{root, "", problems};
  const KeyContext context;
  robot_keys().read_keys(reader, context, robot);

  reader.table("kinematics", [&](TableReader& table) {
    robot.kinematics.emplace();
    kinematics_keys().read(table, context, *robot.kinematics);
    if (robot.kinematics->family == kFiveRFamily) robot.axis_count = joints_of(kFiveRFamily);
  });

  // A mistake in the defaults is reported there, and not again for every axis.
  const ConfigEntry* defaults = root.find(kDefaults);
  const std::size_t before_defaults = problems.size();
  std::size_t wrong_values = 0;
  reader.table(kDefaults, [&](TableReader& table) {
    AxisSpec unused;
    const std::size_t before = problems.size();
    table.allow_missing();
    axis_keys().read(table, context, unused);
    wrong_values = problems.size() - before;
  });
  const std::size_t wrong_defaults = problems.size() - before_defaults;

  const bool ideal = robot.plant == kIdealPlant;
  std::size_t index = 0;
  std::vector<MissingKey> missing;
  std::vector<ReadAxis> good;
  std::vector<std::size_t> bare;  // axes without dynamics
  const std::size_t count = reader.tables("axis", [&](TableReader& table) {
    AxisSpec axis = ideal ? ideal_axis() : AxisSpec{};
    const std::size_t before = problems.size() + missing.size();
    if (defaults != nullptr) table.inherit(&defaults->value);
    table.collect_missing(missing);
    axis_keys().read(table, context, axis);
    if (ideal) std::erase_if(missing, may_be_missing);
    if (problems.size() + missing.size() == before) good.push_back({index, axis});
    if (!axis.dynamics) bare.push_back(index);
    if (index < kAxes) robot.axes[index] = axis;
    ++index;
  });
  // If the axes lack a key, a misspelled key of [defaults] or a misspelled [defaults] may be the cause.
  const bool all_known = wrong_defaults == wrong_values && (defaults != nullptr || !reader.has_unknown());
  if (all_known) report_missing(root, count, missing, problems);
  if (wrong_defaults == 0) check_axes(root, good, problems);
  check_axis_count(reader, robot, count);
  read_bodies(reader, context, bare, index, robot);
  std::vector<Problem> mesh_problems;
  reader.table("meshes", [&](TableReader& table) {
    meshes_keys().read(table, context, robot.meshes);
    load_meshes(table, file.parent_path(), robot, mesh_problems);
  });
  for (std::size_t i = robot.axis_count; i < kAxes; ++i) robot.axes[i] = robot.axes[robot.axis_count - 1];
  const std::string stem = file.stem().string();
  if (!robot.name.empty() && robot.name != stem) {
    reader.problem("name", "expected the name of the file, \"" + stem + "\", found \"" + printable(robot.name) + "\"");
  }
  reader.finish();
  problems.move_to(all);
  std::move(mesh_problems.begin(), mesh_problems.end(), std::back_inserter(all));
  return robot;
}

RobotSpec load_robot(const std::filesystem::path& file) {
  std::vector<Problem> problems;
  RobotSpec robot = load_robot(file, problems);
  if (!problems.empty()) throw InputError{std::move(problems)};
  return robot;
}

RobotSpec find_robot(const std::string& name, const SearchPath& search_path) {
  if (name.ends_with(".toml")) return load_robot(name);
  if (const std::optional<std::filesystem::path> file = search_path.find_robot(name)) return load_robot(*file);
  const std::vector<std::string> known = search_path.robot_names();
  throw InputError{name, "no such robot" + suggestion(name, known) + " (searched: " + search_path.searched() + ")"};
}

}  // namespace armature::cosim
