// The controller's side of the start: what the host has written for it, decoded and checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/host_memory/controller_config.hpp"
#include "controller/host_memory/memory.hpp"
#include "controller/language/store/program_files.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::host_memory {

class BootReader {
 public:
  // Reads the memory. If it is wrong, the values are the defaults and there is no program. The memory must outlive
  // this.
  explicit BootReader(HostMemory& memory) noexcept;

  // False: the controller must not start; the host has been told why.
  [[nodiscard]] bool good() const noexcept { return good_; }
  [[nodiscard]] const RobotModel& robot() const noexcept { return robot_; }
  [[nodiscard]] const ControllerConfig& config() const noexcept { return config_; }
  [[nodiscard]] const ProgramFiles& files() const noexcept { return files_; }
  [[nodiscard]] std::string_view names() const noexcept { return behind(0, files_.size_of_names()); }
  [[nodiscard]] std::string_view texts() const noexcept {
    return behind(files_.size_of_names(), files_.size_of_texts());
  }

  // The program does not load.
  void refuse_program(std::string_view error) noexcept;

 private:
  template <class T>
  [[nodiscard]] bool read(const Block<T>& block, T& value, BootProblem problem) noexcept;
  [[nodiscard]] bool read_blocks() noexcept;
  bool refuse(BootProblem problem, std::size_t place) noexcept;
  [[nodiscard]] std::string_view behind(std::size_t from, std::size_t size) const noexcept;

  HostMemory& memory_;
  RobotModel robot_{};
  ControllerConfig config_{};
  ProgramFiles files_{};
  bool good_;
};

}  // namespace armature::host_memory
