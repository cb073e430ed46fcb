// The files of a program that the controller has from its start on: where each is in the texts behind the host memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "controller/base/members.hpp"
#include "controller/base/misfit.hpp"
#include "controller/language/gcode/flow/flow_index.hpp"
#include "controller/language/text/parts.hpp"

namespace armature {

enum class ProgramLanguage : std::uint8_t { kNone, kGcode, kJob };

// The first file is the one that is executed; the others are its subroutines or further jobs. Their names follow each
// other, and so do their texts.
struct ProgramFiles {
  static constexpr std::size_t kMax = 1 + gcode::FlowIndex::kMaxNames;

  ProgramLanguage language = ProgramLanguage::kNone;
  std::uint32_t count = 0;
  std::array<std::uint32_t, kMax> name_ends{};  // in all names
  std::array<std::uint32_t, kMax> text_ends{};  // in all texts

  [[nodiscard]] constexpr std::span<const std::uint32_t> ends_of_texts() const noexcept {
    return std::span{text_ends}.first(count);
  }
  [[nodiscard]] constexpr std::uint32_t size_of_names() const noexcept { return count == 0 ? 0 : name_ends[count - 1]; }
  [[nodiscard]] constexpr std::uint32_t size_of_texts() const noexcept { return count == 0 ? 0 : text_ends[count - 1]; }
  [[nodiscard]] constexpr std::string_view name(std::size_t file, std::string_view names) const noexcept {
    return piece(name_ends, file, names);
  }
  [[nodiscard]] constexpr std::string_view text(std::size_t file, std::string_view texts) const noexcept {
    return piece(text_ends, file, texts);
  }

  [[nodiscard]] constexpr const void* misfit() const noexcept {
    const bool counted = count <= kMax && (count == 0) == (language == ProgramLanguage::kNone);
    return first_misfit({{&count, counted},
                         {&name_ends, counted && std::is_sorted(name_ends.begin(), name_ends.begin() + count)},
                         {&text_ends, counted && std::is_sorted(text_ends.begin(), text_ends.begin() + count)}});
  }
  ARMATURE_MEMBERS(ProgramFiles, language, count, name_ends, text_ends)

 private:
  using Ends = std::array<std::uint32_t, kMax>;
  [[nodiscard]] static constexpr std::string_view piece(const Ends& ends, std::size_t file,
                                                        std::string_view all) noexcept {
    const std::size_t begin = file == 0 ? 0 : ends[file - 1];
    return part(all, begin, ends[file] - begin);
  }
};

}  // namespace armature
