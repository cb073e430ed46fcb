// The files of a G-code program: the main program, and those of the subroutines that it calls.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/language/gcode/flow/flow_index.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/programs/program_spec.hpp"

namespace armature::cosim {

// The texts of several files as the interpreter reads them, one behind the other.
class JoinedGcode {
 public:
  // The first file is the main program.
  explicit JoinedGcode(std::span<const ProgramFile> files);

  // Valid as long as this.
  [[nodiscard]] gcode::ProgramText text() const { return {.text = text_, .ends = ends_}; }
  // Of one file, with its last line end.
  [[nodiscard]] std::string_view file(std::size_t index) const {
    const std::size_t begin = index == 0 ? 0 : ends_[index - 1];
    return std::string_view{text_}.substr(begin, ends_[index] - begin);
  }
  // Puts blanks in place of a line of the text, from 1.
  void blank_line(std::uint32_t line);

 private:
  std::string text_;
  std::vector<std::uint32_t> ends_;
};

// The subroutines that the files call and do not define, each once: "100", "probe". A call with a computed number is
// none of them. Nothing if the O-words of a file are wrong.
[[nodiscard]] std::vector<std::string> missing_subroutines(std::span<const ProgramFile> files);

// Calls `read` with the path of each file that the program needs besides the first one, until nothing is missing.
// `read` adds the file to `files`.
template <class Read>
void read_subroutines(std::vector<ProgramFile>& files, const std::filesystem::path& folder, Read read) {
  std::vector<std::string> asked_for;
  for (bool again = true; again;) {
    again = false;
    for (const std::string& name : missing_subroutines(files)) {
      if (std::ranges::find(asked_for, name) != asked_for.end()) continue;
      asked_for.push_back(name);
      if (const auto file = find_program(folder, name, ProgramLanguage::kGcode)) {
        read(*file);
        again = true;
      }
    }
  }
}

// Where a line of the joined text is: the index of its file, and the line there.
struct GcodeLine {
  std::size_t file = 0;
  std::uint32_t line = 0;
};
class GcodeLines {
 public:
  GcodeLines() = default;
  explicit GcodeLines(std::span<const ProgramFile> files);
  [[nodiscard]] GcodeLine at(std::uint32_t line) const;

 private:
  std::vector<std::uint32_t> lines_before_;  // of each file
};

}  // namespace armature::cosim
