// The tables of a scenario file, each with its keys and rules.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/scenario/scenario.hpp"
#include "cosim/scenario/table_reader.hpp"

namespace armature::cosim {

// The robot that the keys of a scenario are checked against.
struct ScenarioRobot {
  const RobotSpec* spec = nullptr;  // nullptr: it could not be read; what depends on it is then taken as it is
  std::string file;                 // for messages

  [[nodiscard]] bool lacks_kinematics() const { return spec != nullptr && !spec->kinematics; }
  // Elements that an array with one element an axis must have; 0: any number.
  [[nodiscard]] std::size_t axis_count() const { return spec == nullptr ? 0 : spec->axis_count; }
};

// The keys that say what is run on which robot.
void read_identity(TableReader& root, Scenario& scenario);

// Everything else that stands in the scenario file itself: all of `scenario` but its name, places and robot. `chosen`
// takes the place of the keys; keys that belong to the other variant then have no effect instead of being a problem.
void read_scenario(TableReader& root, const ScenarioRobot& robot, const LogicChoice& chosen, Scenario& scenario);

// [[move]] (move_table.cpp). `scenario` has its duration and its frames.
void read_move(TableReader& table, const ScenarioRobot& robot, const Scenario& scenario, MoveSpec& move);

// [expect] (expect_table.cpp). `paper_keys`: those that the logic of the paper is measured by are allowed.
void read_expect(TableReader& table, const ScenarioRobot& robot, bool paper_keys, ExpectSpec& expect);

// [serial] and [[serial_send]] (serial_table.cpp). `scenario` has its duration and its [serial].
void read_serial(TableReader& table, SerialSpec& serial);
void read_serial_send(TableReader& table, const Scenario& scenario, SerialSendSpec& send);

// [[input]] and [[expect.output]] (pin_table.cpp). `scenario` has its duration.
void read_input(TableReader& table, const Scenario& scenario, InputSpec& input);
// Reports each [[input]] that leaves its pin as it is. `inputs` were read without a problem, in the order of the file.
void require_changes(TableReader& root, const std::vector<InputSpec>& inputs);
void read_expected_output(TableReader& table, double duration_s, std::vector<OutputChangeSpec>& outputs);
// `pin` and `level`, both required.
void read_pin(TableReader& table, std::int64_t& pin, bool& level);

// A string of hexadecimal digits into the bytes that they stand for; returns whether `bytes` was set.
bool read_hex(TableReader& table, std::string_view key, std::string& bytes);

// `at_s`: every timed entry must happen during the run.
void read_at(TableReader& table, double duration_s, double& at_s);

// The place and orientation of a [tool] or a [[frame]].
void read_pose(TableReader& table, PoseSpec& pose);
inline constexpr double kMaxPlaceMm = 100'000;  // far beyond any arm; this only catches nonsense
inline constexpr double kMaxAngleDeg = 36'000;  // soft limits are the controller's business

// An array with one element for each axis of the robot; the axes that it has not keep T{}.
template <class T>
bool read_per_axis(TableReader& table, std::string_view key, std::optional<PerAxis<T>>& out, Rule rule,
                   const ScenarioRobot& robot, Need need = Need::kOptional) {
  rule.count = robot.axis_count();
  std::vector<T> elements;
  if (!table.read(key, elements, rule, need)) return false;
  out.emplace();
  std::copy_n(elements.begin(), std::min(elements.size(), kAxes), out->begin());
  return true;
}

}  // namespace armature::cosim
