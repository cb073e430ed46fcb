// For hosts: a memory with all that a controller starts with.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>
#include <vector>

#include "controller/host_memory/controller_config.hpp"
#include "controller/host_memory/memory.hpp"
#include "controller/host_memory/wire.hpp"
#include "controller/language/store/program_files.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::host_memory {

// The program of the start: at most ProgramFiles::kMax files with 4 GiB. The first one is executed.
struct BootProgram {
  struct File {
    std::string_view name, text;
  };
  ProgramLanguage language = ProgramLanguage::kNone;
  std::vector<File> files{};
};

class BootMemory {
 public:
  BootMemory(const RobotModel& robot, const ControllerConfig& config, const BootProgram& program = {})
      : bytes_{room_for(program)},
        pages_{new (kPage) Byte[whole_pages(bytes_)]{}},
        memory_{*new (pages_.get()) HostMemory{}} {
    memory_.magic = kMagic;
    memory_.layout = layout_of_memory();
    memory_.bytes = static_cast<std::uint32_t>(bytes_);
    put(memory_.robot.data(), 0, robot);
    put(memory_.config.data(), 0, config);
    put(memory_.program.data(), 0, written(program));
  }
  BootMemory(const BootMemory&) = delete;
  BootMemory& operator=(const BootMemory&) = delete;

  [[nodiscard]] HostMemory& memory() noexcept { return memory_; }

  // The memory begins at a page and fills whole pages, so that a simulator of instructions can map it.
  [[nodiscard]] static constexpr std::size_t whole_pages(std::size_t bytes) noexcept {
    return (bytes + kPageBytes - 1) / kPageBytes * kPageBytes;
  }

 private:
  using Byte = std::uint8_t;
  static constexpr std::size_t kPageBytes = 4096;
  static constexpr std::align_val_t kPage{kPageBytes};
  struct Free {
    void operator()(Byte* pages) const noexcept { ::operator delete[](pages, kPage); }
  };
  static_assert(std::is_trivially_destructible_v<HostMemory>);

  static std::size_t room_for(const BootProgram& program) {
    std::size_t bytes = sizeof(HostMemory);
    for (const BootProgram::File& file : program.files) bytes += file.name.size() + file.text.size();
    assert(program.files.size() <= ProgramFiles::kMax && bytes <= std::numeric_limits<std::uint32_t>::max());
    return (bytes + alignof(HostMemory) - 1) / alignof(HostMemory) * alignof(HostMemory);
  }
  // Writes the names and the texts.
  ProgramFiles written(const BootProgram& program) {
    ProgramFiles files{.language = program.language, .count = static_cast<std::uint32_t>(program.files.size())};
    void* const end = &memory_ + 1;
    char* const behind = static_cast<char*>(end);
    char* at = behind;
    const auto append = [&](std::string_view piece) {
      at = std::copy(piece.begin(), piece.end(), at);
      return static_cast<std::uint32_t>(at - behind);
    };
    for (std::size_t i = 0; i < files.count; ++i) files.name_ends[i] = append(program.files[i].name);
    const std::uint32_t names = files.size_of_names();
    for (std::size_t i = 0; i < files.count; ++i) files.text_ends[i] = append(program.files[i].text) - names;
    return files;
  }

  std::size_t bytes_;
  std::unique_ptr<Byte[], Free> pages_;
  HostMemory& memory_;
};

}  // namespace armature::host_memory
