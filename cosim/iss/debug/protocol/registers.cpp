#include "cosim/iss/debug/protocol/registers.hpp"

#include <fmt/format.h>

#include <string>

namespace armature::cosim::iss {
namespace {

std::string description() {
  std::string text =
      "<?xml version=\"1.0\"?>\n<!DOCTYPE target SYSTEM \"gdb-target.dtd\">\n<target version=\"1.0\">\n"
      "<architecture>arm</architecture>\n<feature name=\"org.gnu.gdb.arm.core\">\n";
  for (int i = 0; i <= 12; ++i) text += fmt::format("<reg name=\"r{}\" bitsize=\"32\" type=\"uint32\"/>\n", i);
  text +=
      "<reg name=\"sp\" bitsize=\"32\" type=\"data_ptr\"/>\n<reg name=\"lr\" bitsize=\"32\"/>\n"
      "<reg name=\"pc\" bitsize=\"32\" type=\"code_ptr\"/>\n<reg name=\"cpsr\" bitsize=\"32\"/>\n</feature>\n"
      "<feature name=\"org.gnu.gdb.arm.vfp\">\n";
  for (int i = 0; i < kDoubles; ++i)
    text += fmt::format("<reg name=\"d{}\" bitsize=\"64\" type=\"ieee_double\"/>\n", i);
  return text + "<reg name=\"fpscr\" bitsize=\"32\" type=\"int\" group=\"float\"/>\n</feature>\n</target>\n";
}

}  // namespace

std::string_view target_description() {
  static const std::string kText = description();
  return kText;
}

}  // namespace armature::cosim::iss
