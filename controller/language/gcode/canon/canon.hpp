// The canonical calls: what a G-code program does, without modes, expressions and offsets of the language.
//
// Lengths are in mm and angles in degrees. Places are in the active coordinate system (G5x, G92, tool offset); a sink
// that needs places of the machine computes them with Offsets (offsets.hpp). A CanonInterpreter makes the calls, a sink
// executes or prints them.
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include "controller/language/gcode/reader/axes6.hpp"

namespace armature::gcode {

struct UseLengthUnits {
  bool inches = false;  // for printing only: the calls stay in mm
};
struct SetG5xOffset {
  int index = 1;  // 1..9: G54..G59.3
  Axes6 offset{};
};
struct SetG92Offset {
  Axes6 offset{};
};
struct SetXyRotation {
  double deg = 0.0;
};
struct UseToolLengthOffset {
  Axes6 offset{};
};
struct SelectPlane {
  Plane plane = Plane::kXy;
};
struct SetFeedMode {
  bool inverse_time = false;  // SetFeedRate comes before each motion then
};
struct SetFeedRate {
  double mm_min = 0.0;
  double number = 0.0;  // in the units of the program; deg/min for motions of only A, B and C
};
struct StraightTraverse {
  Axes6 end{};
};
struct StraightFeed {
  Axes6 end{};
};
// In the selected plane. `rotation`: full and partial turns, positive counterclockwise seen from the end of the normal.
struct ArcFeed {
  double first_end = 0.0;
  double second_end = 0.0;
  double first_axis = 0.0;  // the centre
  double second_axis = 0.0;
  std::int32_t rotation = 1;
  double axis_end = 0.0;  // along the normal
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
};
struct Dwell {
  double seconds = 0.0;
};
struct SetMotionControlMode {
  enum class Mode : std::uint8_t { kExactPath, kExactStop, kContinuous };
  Mode mode = Mode::kContinuous;
  double tolerance_mm = 0.0;  // kContinuous; 0: the programmed speed matters more than the corner
};
struct SetNaiveCamTolerance {
  double mm = 0.0;
};
struct SelectTool {
  int number = 0;
};
struct StartChange {};
struct ChangeTool {
  int number = 0;
};
struct SetToolTableEntry {
  int number = 0;
  Axes6 offset{};
};
struct SetSpindleMode {
  double max_rpm = 0.0;  // of a spindle whose surface has a constant speed; 0: constant turns per minute
};
struct SetSpindleSpeed {
  double rpm = 0.0;
};
struct StartSpindle {
  bool clockwise = true;
};
struct StopSpindle {};
struct Mist {
  bool on = false;
};
struct Flood {
  bool on = false;
};
struct EnableOverride {
  enum class Kind : std::uint8_t { kFeed, kSpeed, kAdaptiveFeed, kFeedHold };
  Kind kind = Kind::kFeed;
  bool on = true;
};
struct SetDigitalOutput {
  bool with_motion = false;  // at the start of the next motion
  int index = 0;
  bool on = false;
};
struct SetAnalogOutput {
  bool with_motion = false;
  int index = 0;
  double value = 0.0;
};
// The interpreter continues after give_input().
struct WaitInput {
  enum class Mode : std::uint8_t { kImmediate, kRise, kFall, kHigh, kLow };
  bool analog = false;
  int index = 0;
  Mode mode = Mode::kImmediate;
  double timeout_s = 0.0;
};
struct Text {
  enum class Kind : std::uint8_t { kComment, kMessage, kPrint, kLog };
  Kind kind = Kind::kComment;
  std::string_view text{};  // valid during the call
};
struct ProgramStop {
  bool optional = false;
};
struct PalletShuttle {};
struct ProgramEnd {};

using CanonCall =
    std::variant<UseLengthUnits, SetG5xOffset, SetG92Offset, SetXyRotation, UseToolLengthOffset, SelectPlane,
                 SetFeedMode, SetFeedRate, StraightTraverse, StraightFeed, ArcFeed, Dwell, SetMotionControlMode,
                 SetNaiveCamTolerance, SelectTool, StartChange, ChangeTool, SetToolTableEntry, SetSpindleMode,
                 SetSpindleSpeed, StartSpindle, StopSpindle, Mist, Flood, EnableOverride, SetDigitalOutput,
                 SetAnalogOutput, WaitInput, Text, ProgramStop, PalletShuttle, ProgramEnd>;

class CanonSink {
 public:
  // `line` of the program, from 1; 0: before its first line.
  virtual void on_call(const CanonCall& call, std::uint32_t line) noexcept = 0;

 protected:
  ~CanonSink() = default;
};

}  // namespace armature::gcode
