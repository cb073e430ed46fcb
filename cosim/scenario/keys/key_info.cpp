#include "cosim/scenario/keys/key_info.hpp"

#include <fmt/format.h>

namespace armature::cosim {

std::string needs_text(Needs needs, std::string_view robot_file, std::string_view quote) {
  switch (needs) {
    case Needs::kKinematics:
      return fmt::format("{0}[kinematics]{0} in {1}", quote, robot_file);
    case Needs::kPaper:
      return fmt::format("{0}variant = \"paper\"{0}", quote);
    case Needs::kSerial:
      return fmt::format("a table {0}[serial]{0}", quote);
    case Needs::kProgram:
      return fmt::format("a key {0}program{0}, or a program that the pendant sends", quote);
    case Needs::kGcode:
      return fmt::format(
          "{0}program = \"NAME.ngc\"{0}, or a .ngc file that the pendant sends (a live one: {0}[pendant]{0})", quote);
    case Needs::kJob:
      return fmt::format(
          "{0}program = \"NAME.jbi\"{0}, or a .jbi file that the pendant sends (a live one: {0}[pendant]{0})", quote);
    case Needs::kFlops:
      return fmt::format("{0}engine = \"rtl\"{0}, as only the RTL has flops", quote);
    case Needs::kMemory:
      return fmt::format("{0}processor = \"a9\"{0} and {0}cpi{0} in {0}[cpu]{0}, as only these cores have a memory",
                         quote);
    case Needs::kNothing:
      break;
  }
  return {};
}

std::string condition_text(const Condition& condition) {
  std::string text{condition.key};
  if (!condition.values.empty()) text += " = " + quoted_list(condition.values);
  return text;
}

}  // namespace armature::cosim
