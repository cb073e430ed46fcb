#include "cosim/pendant/step_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "controller/pendant/parts/staged_move.hpp"
#include "cosim/programs/program_name.hpp"

namespace armature::cosim {
namespace {

using pendant::Content;
using pendant::Frame;
using pendant::MoveOption;
using pendant::Opcode;
using pendant::StagedMove;
using Numbers = std::vector<std::int32_t>;

constexpr double kPerPercent = 100;  // units of 0.01 %

std::int32_t rounded(double value) {
  return static_cast<std::int32_t>(std::floor(value + 0.5));
}

Numbers point_of(const PerAxis<double>& joints_deg, const RobotSpec& robot) {
  Numbers point;
  for (std::size_t axis = 0; axis < robot.axis_count; ++axis) {
    point.push_back(rounded(pulses_of(robot.axes[axis], joints_deg[axis])));
  }
  return point;
}

Numbers point_of(const std::array<double, 3>& xyz_mm, const std::array<double, 3>& rpy_deg) {
  Numbers point;
  for (const double mm : xyz_mm) point.push_back(rounded(mm * 1e3));
  for (const double deg : rpy_deg) point.push_back(rounded(deg * 1e4));
  return point;
}

std::vector<Frame> move_frames(const PendantStepSpec& step, const RobotSpec& robot) {
  std::vector<Frame> frames;
  StagedMove staged;
  const auto target = [&](std::size_t number, const Numbers& point) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const std::size_t parameter = number * StagedMove::kParametersOfPoint + i;
      frames.push_back(
          {.opcode = Opcode::kTarget, .parameter = static_cast<std::uint8_t>(parameter), .payload = point[i]});
      static_cast<void>(staged.stage_target(parameter, point[i]));
    }
  };
  const auto option = [&](MoveOption which, std::optional<double> percent) {
    if (!percent) return;
    const std::int32_t value = rounded(*percent * kPerPercent);
    frames.push_back(
        {.opcode = Opcode::kTargetOption, .parameter = static_cast<std::uint8_t>(which), .payload = value});
    staged.stage_option(which, value);
  };
  const Numbers end = step.xyz_mm ? point_of(*step.xyz_mm, step.rpy_deg) : point_of(*step.joints_deg, robot);
  if (step.path == "arc") target(0, point_of(*step.via_mm, step.rpy_deg));
  target(step.path == "arc" ? 1 : 0, end);
  option(MoveOption::kSpeed, step.speed_percent);
  option(MoveOption::kAcceleration, step.accel_percent);
  const Opcode opcode = step.path == "joints" ? Opcode::kMoveJoints
                        : step.path == "line" ? Opcode::kMoveLine
                                              : Opcode::kMoveArc;
  frames.push_back({.opcode = opcode, .payload = staged.check()});
  return frames;
}

Opcode opcode_of(std::string_view name) {
  return std::ranges::find(pendant::kOpcodeRules, name, &pendant::OpcodeRule::name)->opcode;
}

Frame download_frame(const PendantStepSpec& step) {
  const bool gcode = program_language(step.file) == ProgramLanguage::kGcode;
  const Content kind = gcode ? Content::kGcode : step.adds_job ? Content::kFurtherJob : Content::kJob;
  return {.opcode = Opcode::kProgramBegin,
          .parameter = static_cast<std::uint8_t>(kind),
          .payload = static_cast<std::int32_t>(step.text.size())};
}

}  // namespace

std::vector<Frame> frames_of(const PendantStepSpec& step, const RobotSpec& robot) {
  switch (step.act) {
    case PendantAct::kSend:
      return {{.opcode = opcode_of(step.command),
               .parameter = static_cast<std::uint8_t>(step.parameter),
               .payload = static_cast<std::int32_t>(step.payload)}};
    case PendantAct::kMove:
      return move_frames(step, robot);
    case PendantAct::kDownload:
      return {download_frame(step)};
    case PendantAct::kWait:
    case PendantAct::kJog:
    case PendantAct::kEstop:
    case PendantAct::kReadMessage:
      break;
  }
  return {};
}

Frame jog_frame(const PendantStepSpec& step) {
  return {.opcode = Opcode::kJogContinuous,
          .parameter = static_cast<std::uint8_t>(step.axis - 1),
          .payload = rounded(step.percent * kPerPercent)};
}

}  // namespace armature::cosim
