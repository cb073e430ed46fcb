#include "cosim/scenario/files/points_file.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>

#include "cosim/poses/number_csv.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

void read_points(const std::string& text, const std::string& file, std::vector<std::array<double, 3>>& points) {
  const std::array<CsvLayout, 1> layouts{
      CsvLayout{{"x_mm", kMaxPlaceMm, "mm"}, {"y_mm", kMaxPlaceMm, "mm"}, {"z_mm", kMaxPlaceMm, "mm"}}};
  std::size_t rows = 0;
  read_number_csv(text, file, layouts, [&](const NumberRow& row, CsvProblems& problems) {
    if (++rows == kMaxPoints + 1) {
      problems.add(row.line, 1, "", "more than " + std::to_string(kMaxPoints) + " points");
    }
    if (rows > kMaxPoints) return;
    const std::array<double, 3> point{row.values[0], row.values[1], row.values[2]};
    if (points.empty() || point != points.back()) points.push_back(point);
  });
  if (points.empty()) throw InputError{file, "expected at least one point"};
}

}  // namespace

void load_points(Scenario& scenario, std::vector<Problem>& all) {
  for (CommandSpec& move : scenario.moves) {
    auto* polyline = std::get_if<PolylineSpec>(&move.kind);
    if (polyline == nullptr) continue;
    const fs::path file = fs::path{scenario.file}.parent_path() / polyline->points_file;
    const std::string name = file.lexically_normal().string();
    if (!is_file(file)) {
      Problem& problem = all.emplace_back();
      problem.file = scenario.file;
      problem.origin.line = move.line;
      problem.key = "move[" + std::to_string(move.index) + "].points_file";
      problem.message = "no such file: " + printable(name);
      continue;
    }
    try {
      const std::string text = read_text_file(file, kMaxTableBytes);
      read_points(text, name, polyline->points_mm);
      scenario.sources.push_back(input_file(name, text));
    } catch (const InputError& error) {
      all.insert(all.end(), error.problems().begin(), error.problems().end());
    }
  }
}

}  // namespace armature::cosim
