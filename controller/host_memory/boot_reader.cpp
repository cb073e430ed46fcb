#include "controller/host_memory/boot_reader.hpp"

#include <algorithm>
#include <atomic>

#include "controller/host_memory/wire.hpp"

namespace armature::host_memory {

BootReader::BootReader(HostMemory& memory) noexcept : memory_{memory}, good_{read_blocks()} {
  if (good_) return;
  robot_ = {};
  config_ = {};
  files_ = {};
}

bool BootReader::read_blocks() noexcept {
  if (memory_.magic != kMagic || memory_.layout != layout_of_memory() || memory_.bytes < sizeof(HostMemory)) {
    return refuse(BootProblem::kOtherLayout, 0);
  }
  if (!read(memory_.robot, robot_, BootProblem::kRobot) || !read(memory_.config, config_, BootProblem::kConfig) ||
      !read(memory_.program, files_, BootProblem::kProgram)) {
    return false;
  }
  const std::size_t room = memory_.bytes - sizeof(HostMemory);
  if (files_.size_of_names() > room || files_.size_of_texts() > room - files_.size_of_names()) {
    return refuse(BootProblem::kProgram, begin_of_member(0, files_, &files_.text_ends));
  }
  return true;
}

template <class T>
bool BootReader::read(const Block<T>& block, T& value, BootProblem problem) noexcept {
  std::size_t at = 0;
  return take(block.data(), at, value) || refuse(problem, at);
}

bool BootReader::refuse(BootProblem problem, std::size_t place) noexcept {
  memory_.boot.place = static_cast<std::uint32_t>(place);
  std::atomic_ref<std::uint32_t>{memory_.boot.problem}.store(static_cast<std::uint32_t>(problem),
                                                             std::memory_order_release);
  return false;
}

void BootReader::refuse_program(std::string_view error) noexcept {
  const std::size_t size = std::min(error.size(), memory_.boot.text.size());
  std::copy_n(error.begin(), size, memory_.boot.text.begin());
  good_ = refuse(BootProblem::kProgramText, 0);
}

std::string_view BootReader::behind(std::size_t from, std::size_t size) const noexcept {
  const void* const end = &memory_ + 1;
  return {static_cast<const char*>(end) + from, size};
}

}  // namespace armature::host_memory
