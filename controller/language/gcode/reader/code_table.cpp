#include "controller/language/gcode/reader/code_table.hpp"

#include <array>

namespace armature::gcode {
namespace {

using enum AxisUse;

// Ascending in each letter.
constexpr std::array kCodes{
    CodeInfo{'g', 0, Group::kMotion, kMoves, "", "move at rapid speed"},
    CodeInfo{'g', 10, Group::kMotion, kMoves, "", "straight line at the feed rate"},
    CodeInfo{'g', 20, Group::kMotion, kMoves, "ijkrp", "arc or helix clockwise; P turns"},
    CodeInfo{'g', 30, Group::kMotion, kMoves, "ijkrp", "arc or helix counterclockwise; P turns"},
    CodeInfo{'g', 40, Group::kOnce, kNone, "p", "dwell P seconds"},
    CodeInfo{'g', 50, Group::kUnsupported, kNone, "", "cubic spline"},
    CodeInfo{'g', 51, Group::kUnsupported, kNone, "", "quadratic spline"},
    CodeInfo{'g', 52, Group::kUnsupported, kNone, "", "NURBS"},
    CodeInfo{'g', 53, Group::kUnsupported, kNone, "", "end of NURBS"},
    CodeInfo{'g', 70, Group::kUnsupported, kNone, "", "diameter mode of lathes"},
    CodeInfo{'g', 80, Group::kUnsupported, kNone, "", "radius mode of lathes"},
    CodeInfo{'g', 100, Group::kOnce, kValues, "lpr",
             "set data: L1, L10, L11 tool P; L2, L20 coordinate system P (0: the active one), R rotation"},
    CodeInfo{'g', 170, Group::kPlane, kNone, "", "plane XY"},
    CodeInfo{'g', 171, Group::kUnsupported, kNone, "", "plane UV"},
    CodeInfo{'g', 180, Group::kPlane, kNone, "", "plane XZ"},
    CodeInfo{'g', 181, Group::kUnsupported, kNone, "", "plane UW"},
    CodeInfo{'g', 190, Group::kPlane, kNone, "", "plane YZ"},
    CodeInfo{'g', 191, Group::kUnsupported, kNone, "", "plane VW"},
    CodeInfo{'g', 200, Group::kUnits, kNone, "", "inches"},
    CodeInfo{'g', 210, Group::kUnits, kNone, "", "millimetres"},
    CodeInfo{'g', 280, Group::kOnce, kValues, "", "move to the stored place, by way of the axis words"},
    CodeInfo{'g', 281, Group::kOnce, kNone, "", "store the present place for G28"},
    CodeInfo{'g', 300, Group::kOnce, kValues, "", "move to the second stored place, by way of the axis words"},
    CodeInfo{'g', 301, Group::kOnce, kNone, "", "store the present place for G30"},
    CodeInfo{'g', 330, Group::kUnsupported, kNone, "", "motion synchronised with the spindle"},
    CodeInfo{'g', 331, Group::kUnsupported, kNone, "", "rigid tapping"},
    CodeInfo{'g', 382, Group::kUnsupported, kNone, "", "probe towards contact"},
    CodeInfo{'g', 383, Group::kUnsupported, kNone, "", "probe towards contact without error"},
    CodeInfo{'g', 384, Group::kUnsupported, kNone, "", "probe away from contact"},
    CodeInfo{'g', 385, Group::kUnsupported, kNone, "", "probe away from contact without error"},
    CodeInfo{'g', 400, Group::kCutter, kNone, "", "no cutter compensation"},
    CodeInfo{'g', 410, Group::kUnsupported, kNone, "", "cutter compensation left"},
    CodeInfo{'g', 411, Group::kUnsupported, kNone, "", "dynamic cutter compensation left"},
    CodeInfo{'g', 420, Group::kUnsupported, kNone, "", "cutter compensation right"},
    CodeInfo{'g', 421, Group::kUnsupported, kNone, "", "dynamic cutter compensation right"},
    CodeInfo{'g', 430, Group::kToolLength, kNone, "h", "tool offset of tool H, of the present tool without H"},
    CodeInfo{'g', 431, Group::kToolLength, kValues, "", "tool offset from the axis words"},
    CodeInfo{'g', 432, Group::kUnsupported, kNone, "", "additional tool offset"},
    CodeInfo{'g', 490, Group::kToolLength, kNone, "", "no tool offset"},
    CodeInfo{'g', 520, Group::kOnce, kValues, "", "local offset of the coordinate systems"},
    CodeInfo{'g', 530, Group::kOnce, kNone, "", "this line in machine coordinates, with G0 or G1"},
    CodeInfo{'g', 540, Group::kCoordinates, kNone, "", "coordinate system 1"},
    CodeInfo{'g', 550, Group::kCoordinates, kNone, "", "coordinate system 2"},
    CodeInfo{'g', 560, Group::kCoordinates, kNone, "", "coordinate system 3"},
    CodeInfo{'g', 570, Group::kCoordinates, kNone, "", "coordinate system 4"},
    CodeInfo{'g', 580, Group::kCoordinates, kNone, "", "coordinate system 5"},
    CodeInfo{'g', 590, Group::kCoordinates, kNone, "", "coordinate system 6"},
    CodeInfo{'g', 591, Group::kCoordinates, kNone, "", "coordinate system 7"},
    CodeInfo{'g', 592, Group::kCoordinates, kNone, "", "coordinate system 8"},
    CodeInfo{'g', 593, Group::kCoordinates, kNone, "", "coordinate system 9"},
    CodeInfo{'g', 610, Group::kControl, kNone, "", "exact path"},
    CodeInfo{'g', 611, Group::kControl, kNone, "", "exact stop"},
    CodeInfo{'g', 640, Group::kControl, kNone, "pq", "continuous path; P tolerance of corners, Q of joined lines"},
    CodeInfo{'g', 700, Group::kUnsupported, kNone, "", "lathe finishing"},
    CodeInfo{'g', 710, Group::kUnsupported, kNone, "", "lathe roughing"},
    CodeInfo{'g', 720, Group::kUnsupported, kNone, "", "lathe facing"},
    CodeInfo{'g', 730, Group::kMotion, kMoves, "rlq", "drill in pecks of Q that break chips; R clearance, L repeats"},
    CodeInfo{'g', 740, Group::kMotion, kMoves, "rlp",
             "left-hand tapping: drill, turn the spindle round, dwell P seconds, feed out; R clearance, L repeats"},
    CodeInfo{'g', 760, Group::kUnsupported, kNone, "", "threading"},
    CodeInfo{'g', 800, Group::kMotion, kNone, "", "no motion mode"},
    CodeInfo{'g', 810, Group::kMotion, kMoves, "rl", "drill to the bottom; R clearance, L repeats"},
    CodeInfo{'g', 820, Group::kMotion, kMoves, "rlp", "drill and dwell P seconds; R clearance, L repeats"},
    CodeInfo{'g', 830, Group::kMotion, kMoves, "rlq", "drill in pecks of Q; R clearance, L repeats"},
    CodeInfo{'g', 840, Group::kMotion, kMoves, "rlp", "right-hand tapping, as G74 with M3"},
    CodeInfo{'g', 850, Group::kUnsupported, kNone, "", "boring, feed out"},
    CodeInfo{'g', 860, Group::kUnsupported, kNone, "", "boring, spindle stop, rapid out"},
    CodeInfo{'g', 870, Group::kUnsupported, kNone, "", "back boring"},
    CodeInfo{'g', 880, Group::kUnsupported, kNone, "", "boring, manual out"},
    CodeInfo{'g', 890, Group::kUnsupported, kNone, "", "boring, dwell, feed out"},
    CodeInfo{'g', 900, Group::kDistance, kNone, "", "absolute distances"},
    CodeInfo{'g', 901, Group::kArcDistance, kNone, "", "absolute centres of arcs"},
    CodeInfo{'g', 910, Group::kDistance, kNone, "", "incremental distances"},
    CodeInfo{'g', 911, Group::kArcDistance, kNone, "", "incremental centres of arcs"},
    CodeInfo{'g', 920, Group::kOnce, kValues, "", "offset so that the present place gets the axis words"},
    CodeInfo{'g', 921, Group::kOnce, kNone, "", "delete the offset of G92"},
    CodeInfo{'g', 922, Group::kOnce, kNone, "", "suspend the offset of G92"},
    CodeInfo{'g', 923, Group::kOnce, kNone, "", "restore the offset of G92"},
    CodeInfo{'g', 930, Group::kFeedMode, kNone, "", "F is one divided by the minutes of the motion"},
    CodeInfo{'g', 940, Group::kFeedMode, kNone, "", "F is in units per minute"},
    CodeInfo{'g', 950, Group::kUnsupported, kNone, "", "feed per revolution"},
    CodeInfo{'g', 960, Group::kSpindleMode, kNone, "d",
             "S is the speed of the surface, D the most turns per minute; the arm reports it only"},
    CodeInfo{'g', 970, Group::kSpindleMode, kNone, "", "S is in turns per minute"},
    CodeInfo{'g', 980, Group::kRetract, kNone, "", "cycles retract to the height before the cycle"},
    CodeInfo{'g', 990, Group::kRetract, kNone, "", "cycles retract to the clearance plane R"},
    CodeInfo{'m', 0, Group::kStop, kNone, "", "pause"},
    CodeInfo{'m', 10, Group::kStop, kNone, "", "optional pause"},
    CodeInfo{'m', 20, Group::kStop, kNone, "", "end of the program"},
    CodeInfo{'m', 30, Group::kSpindle, kNone, "", "spindle clockwise, or laser on"},
    CodeInfo{'m', 40, Group::kSpindle, kNone, "", "spindle counterclockwise"},
    CodeInfo{'m', 50, Group::kSpindle, kNone, "", "spindle stop, or laser off"},
    CodeInfo{'m', 60, Group::kToolChange, kNone, "", "change to the tool that T selected"},
    CodeInfo{'m', 70, Group::kCoolant, kNone, "", "mist on"},
    CodeInfo{'m', 80, Group::kCoolant, kNone, "", "flood on"},
    CodeInfo{'m', 90, Group::kCoolant, kNone, "", "mist and flood off"},
    CodeInfo{'m', 190, Group::kUnsupported, kNone, "", "orient the spindle"},
    CodeInfo{'m', 300, Group::kStop, kNone, "", "pallet shuttle and end of the program"},
    CodeInfo{'m', 480, Group::kOverride, kNone, "", "overrides of feed and spindle on"},
    CodeInfo{'m', 490, Group::kOverride, kNone, "", "overrides of feed and spindle off"},
    CodeInfo{'m', 500, Group::kOverride, kNone, "p", "feed override on, or off with P0"},
    CodeInfo{'m', 510, Group::kOverride, kNone, "p", "spindle override on, or off with P0"},
    CodeInfo{'m', 520, Group::kOverride, kNone, "p", "adaptive feed on, or off with P0"},
    CodeInfo{'m', 530, Group::kOverride, kNone, "p", "feed hold on, or off with P0"},
    CodeInfo{'m', 600, Group::kStop, kNone, "", "pallet shuttle and pause"},
    CodeInfo{'m', 620, Group::kOutputs, kNone, "p", "output P on at the start of the next motion"},
    CodeInfo{'m', 630, Group::kOutputs, kNone, "p", "output P off at the start of the next motion"},
    CodeInfo{'m', 640, Group::kOutputs, kNone, "p", "output P on at once"},
    CodeInfo{'m', 650, Group::kOutputs, kNone, "p", "output P off at once"},
    CodeInfo{'m', 660, Group::kOutputs, kNone, "pelq",
             "wait for input P (L0 at once, L1 rise, L2 fall, L3 high, L4 low) for Q seconds, or read analog input E"},
    CodeInfo{'m', 670, Group::kOutputs, kNone, "eq", "analog output E to Q at the start of the next motion"},
    CodeInfo{'m', 680, Group::kOutputs, kNone, "eq", "analog output E to Q at once"},
    CodeInfo{'m', 700, Group::kState, kNone, "", "save the modal state"},
    CodeInfo{'m', 710, Group::kState, kNone, "", "forget the saved modal state"},
    CodeInfo{'m', 720, Group::kState, kNone, "", "restore the modal state"},
    CodeInfo{'m', 730, Group::kState, kNone, "", "save the modal state until the return"},
    CodeInfo{'m', 980, Group::kFlow, kNone, "pl", "call subprogram P, which begins with its O-number alone, L times"},
    CodeInfo{'m', 990, Group::kFlow, kNone, "", "return from a subprogram; in the main program its end"},
};

}  // namespace

std::span<const CodeInfo> code_table() noexcept {
  return kCodes;
}

const CodeInfo* find_code(char letter, std::int32_t tenths) noexcept {
  for (const CodeInfo& info : kCodes) {
    if (info.letter == letter && info.tenths == tenths) return &info;
  }
  return nullptr;
}

std::string_view name_of(Group group) noexcept {
  switch (group) {
    case Group::kOnce:
      return "own line";
    case Group::kMotion:
      return "motion";
    case Group::kPlane:
      return "plane";
    case Group::kDistance:
      return "distances";
    case Group::kArcDistance:
      return "centres of arcs";
    case Group::kFeedMode:
      return "feed";
    case Group::kUnits:
      return "units";
    case Group::kCutter:
      return "cutter";
    case Group::kToolLength:
      return "tool offset";
    case Group::kRetract:
      return "retract";
    case Group::kCoordinates:
      return "coordinates";
    case Group::kControl:
      return "path control";
    case Group::kStop:
      return "stop";
    case Group::kOutputs:
      return "inputs and outputs";
    case Group::kToolChange:
      return "tool change";
    case Group::kSpindle:
      return "spindle";
    case Group::kSpindleMode:
      return "spindle mode";
    case Group::kCoolant:
      return "coolant";
    case Group::kOverride:
      return "override";
    case Group::kState:
      return "modal state";
    case Group::kUnsupported:
      return "not supported";
    case Group::kFlow:
      return "first of a line";
  }
  return "";
}

}  // namespace armature::gcode
