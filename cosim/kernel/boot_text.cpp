#include "cosim/kernel/boot_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "controller/host_memory/layout.hpp"

namespace armature::cosim {
namespace {

using host_memory::BootProblem;
using host_memory::Field;
using host_memory::NamePart;

std::string full_name(const NamePart& part) {
  if (part.outer == nullptr) return std::string{part.name};
  const std::string outer = full_name(*part.outer);
  return part.name.empty() ? fmt::format("{}[{}]", outer, part.index) : fmt::format("{}.{}", outer, part.name);
}

// The value of a block of type T at a byte, or behind it if there is none.
template <class T>
std::string value_at(std::string_view block, std::size_t place) {
  std::string name;
  auto find = [&](const Field& field) {
    if (name.empty() && field.offset + field.bytes > place) name = full_name(*field.name);
  };
  host_memory::describe<T>(0, NamePart{.name = block}, find);
  return "the value of " + name + " is not allowed";
}

std::string problem_text(const host_memory::BootReport& report) {
  switch (static_cast<BootProblem>(report.problem)) {
    case BootProblem::kNone:
      break;
    case BootProblem::kOtherLayout:
      return "it was built for another layout of the host memory";
    case BootProblem::kRobot:
      return value_at<RobotModel>("robot", report.place);
    case BootProblem::kConfig:
      return value_at<ControllerConfig>("config", report.place);
    case BootProblem::kProgram:
      return value_at<ProgramFiles>("program", report.place);
    case BootProblem::kProgramText:
      return "its program does not load: " +
             std::string{report.text.begin(), std::find(report.text.begin(), report.text.end(), '\0')};
  }
  return fmt::format("problem {}", report.problem);
}

}  // namespace

std::string boot_text(const host_memory::BootReport& report) {
  return "the controller has not started: " + problem_text(report);
}

}  // namespace armature::cosim
