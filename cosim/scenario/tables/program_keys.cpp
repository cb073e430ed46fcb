// [gcode] and [job]: how the controller executes the program of the scenario.
#include <string>

#include "controller/language/gcode/canon/offsets.hpp"
#include "controller/language/job/state/machine_setup.hpp"
#include "cosim/scenario/moves/path.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxAnalog = 1e6;

std::string check_analog(const GcodeAnalogSpec& analog, const KeyContext& context) {
  const bool taken = is_taken(context.scenario->gcode.analog, analog, &GcodeAnalogSpec::number);
  return taken ? "there is another table of this output" : "";
}

std::string check_bits(const GcodeAnalogSpec& analog, const KeyContext&) {
  if (analog.first_pin + analog.bits <= kToolPins + 1) return {};
  return "expected at most " + std::to_string(kToolPins + 1 - analog.first_pin) + ", because the last pin is " +
         std::to_string(kToolPins) + ", found " + std::to_string(analog.bits);
}

std::string check_frame(GcodeSpec& gcode, const KeyContext& context) {
  if (gcode.frame_name == kToolFrameName) return "a program needs `base` or a `[[frame]]`";
  return find_frame(gcode.frame_name, gcode.frame, context);
}

template <class Spec>
Key<Spec> switched_pin(std::string_view name, std::int64_t Spec::*pin, std::string_view text) {
  return key(name, pin, between(1, kToolPins), text).without("none");
}

}  // namespace

const KeyTable<GcodeSpec>& gcode_keys() {
  static const KeyTable<GcodeSpec> kTable{
      .text =
          "Places a G-code program in the cell and says what its motions and codes mean for the arm. The program is "
          "checked as a whole before anything moves: a place that the arm cannot reach is an alarm with its line.",
      .keys =
          {
              key("frame", &GcodeSpec::frame_name, anything(),
                  "Frame whose coordinates are those of the machine (G53): `base` or the name of a `[[frame]]`.")
                  .checked(check_frame),
              named_key("orientation", &GcodeSpec::orientation,
                        "How the tool turns. `kept`: as it stands when the program begins. `normal`: the tool points "
                        "against z of the frame, and A, B and C turn it about the fixed x, then y, then z axis of the "
                        "frame. `tangent`: the tool turns with the direction of the path."),
              key("rapid_mm_s", &GcodeSpec::rapid_mm_s, above(0, kMaxSpeed, "mm/s"), "Largest speed of G0."),
              key("rapid_turn_deg_s", &GcodeSpec::rapid_turn_deg_s, above(0, kMaxSpeed, "deg/s"),
                  "Largest angular speed of the tool."),
              key("accel_mm_s2", &GcodeSpec::accel_mm_s2, above(0, kMaxAccel, "mm/s^2"),
                  "Largest acceleration of the tool centre point."),
              key("turn_accel_deg_s2", &GcodeSpec::turn_accel_deg_s2, above(0, kMaxAccel, "deg/s^2"),
                  "Largest angular acceleration of the tool."),
              key("corner_mm", &GcodeSpec::corner_mm, between(0, kMaxBlendMm, "mm"),
                  "Largest distance by which rounded corners may leave the path with G64 without P."),
              switched_pin("spindle_pin", &GcodeSpec::spindle_pin,
                           "Output of the tool that M3 and M4 switch on and M5 switches off."),
              switched_pin("mist_pin", &GcodeSpec::mist_pin, "The same for M7 and M9."),
              switched_pin("flood_pin", &GcodeSpec::flood_pin, "The same for M8 and M9."),
              key("tools", &GcodeSpec::tools, between(1, gcode::kMaxTools - 1),
                  "Numbers of the tools that the program may name with T and H. All of them are the tool that the arm "
                  "carries, so they have no offset."),
          },
      .tables = {tables("analog", &GcodeSpec::analog, gcode_analog_keys(), 4)}};
  return kTable;
}

const KeyTable<GcodeAnalogSpec>& gcode_analog_keys() {
  static const KeyTable<GcodeAnalogSpec> kTable{
      .text =
          "Each table is an analog output: a binary number on successive outputs of the tool, the lowest bit first. A "
          "motion of the program switches up to four pins in step with its start (M62, M63, M67); the arm stops before "
          "a motion for further ones.",
      .keys = {
          key("number", &GcodeAnalogSpec::number, between(0, 3), "Number of the output: E of M67 and M68.")
              .required()
              .checked(check_analog),
          key("first_pin", &GcodeAnalogSpec::first_pin, between(1, kToolPins), "Output of the lowest bit.").required(),
          key("bits", &GcodeAnalogSpec::bits, between(1, kToolPins), "Number of bits.").required().checked(check_bits),
          key("full", &GcodeAnalogSpec::full, above(0, kMaxAnalog), "Value at which all bits are high."),
      }};
  return kTable;
}

const KeyTable<JobSpec>& job_keys() {
  static const KeyTable<JobSpec> kTable{
      .text = "What the motions of a robot program mean for the arm.",
      .keys =
          {
              key("pl_radius_mm", &JobSpec::pl_radius_mm, between(0, kMaxBlendMm, "mm"),
                  "Largest distance by which rounded corners may leave the path for PL=1 to PL=8."),
              key("accel_mm_s2", &JobSpec::accel_mm_s2, above(0, kMaxAccel, "mm/s^2"),
                  "Acceleration of the tool centre point with ACC=100."),
              key("turn_accel_deg_s2", &JobSpec::turn_accel_deg_s2, above(0, kMaxAccel, "deg/s^2"),
                  "Angular acceleration of the tool with ACC=100."),
              switched_pin(
                  "arc_pin", &JobSpec::arc_pin,
                  "Output of the tool that ARCON and COMARCON switch on and ARCOF and COMARCOF switch off. Without "
                  "it these instructions are alarms."),
              switched_pin("weave_pin", &JobSpec::weave_pin, "The same for WVON and WVOF."),
              switched_pin("tool_pin", &JobSpec::tool_pin, "The same for TOOLON and TOOLOF."),
          },
      .tables = {tables("tool", &JobSpec::tools, job_tool_keys(), job::kToolNumbers)}};
  return kTable;
}

}  // namespace armature::cosim
