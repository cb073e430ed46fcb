#include "cosim/programs/program_name.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "controller/language/gcode/reader/source_line.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

struct Ending {
  std::string_view text;
  ProgramLanguage language;
};

// For each language the one that is preferred comes first.
constexpr std::array kEndings{Ending{".ngc", ProgramLanguage::kGcode}, Ending{".nc", ProgramLanguage::kGcode},
                              Ending{".gcode", ProgramLanguage::kGcode}, Ending{".jbi", ProgramLanguage::kJob}};

std::string in_lower_case(std::string_view text) {
  std::string lower{text};
  std::ranges::transform(lower, lower.begin(), gcode::to_lower);
  return lower;
}

std::optional<fs::path> find_file(const fs::path& folder, const std::string& name) {
  if (is_file(folder / name)) return folder / name;
  const std::string wanted = in_lower_case(name);
  std::optional<std::string> found;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator{folder.empty() ? fs::path{"."} : folder, problem}) {
    std::string file = entry.path().filename().string();
    if (in_lower_case(file) != wanted || !is_file(entry.path())) continue;
    if (!found || file < *found) found = std::move(file);
  }
  return found ? std::optional{folder / *found} : std::nullopt;
}

}  // namespace

ProgramLanguage program_language(std::string_view file) {
  const std::string lower = in_lower_case(file);
  const auto* const ending =
      std::ranges::find_if(kEndings, [&](const Ending& one) { return lower.ends_with(one.text); });
  return ending == kEndings.end() ? ProgramLanguage::kNone : ending->language;
}

std::optional<fs::path> find_program(const fs::path& folder, std::string_view name, ProgramLanguage language) {
  for (const Ending& ending : kEndings) {
    if (ending.language != language) continue;
    if (auto file = find_file(folder, std::string{name}.append(ending.text))) return file;
  }
  return std::nullopt;
}

}  // namespace armature::cosim
