#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/recorded_run.hpp"
#include "cosim/plot/joints_figure.hpp"
#include "cosim/plot/path_figure.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kPlotDetails = R"(Examples:
  armature run fig9_joint_move && armature plot out/fig9_joint_move --figure joints -o joints.svg
  armature run jog --set trace.tcp=true && armature plot out/jog --figure path

Draws a picture of a run from its trace.csv and summary.json. The same files give the same picture, byte for byte.
'joints' shows angle and speed of each joint over time. 'path' shows the path of the tool in the plane in which it
draws. It needs the columns of the tool centre point, which the trace of a scenario with poses always has.
Exit code: 0 ok, 2 bad input, 3 internal error.)";

using Figure = std::string (*)(const RunRecord&);
constexpr std::array<std::pair<const char*, Figure>, 2> kFigures{{{"joints", joints_figure}, {"path", path_figure}}};

struct PlotOptions {
  std::filesystem::path folder;
  std::string figure;
  std::optional<std::filesystem::path> out;  // default FOLDER/FIGURE.svg
};

int plot(const PlotOptions& given) {
  const std::filesystem::path out = given.out.value_or(given.folder / (given.figure + ".svg"));
  const RunRecord run = recorded_run(given.folder);
  OutputFiles files;
  reads_results(files, given.folder);
  files.writes(out, "-o", Writing::kInPlace);
  for (const auto& [name, draw] : kFigures) {
    if (given.figure == name) replace_text_file(out, draw(run));
  }
  std::cout << printable(out.string(), kShowAll) << '\n';
  return kExitOk;
}

CommandAction declare_plot(CLI::App& app) {
  const auto options = std::make_shared<PlotOptions>();
  app.add_option("folder", options->folder, "Folder with the results of a run")->required()->type_name(kFolderValue);
  std::vector<std::string> names;
  names.reserve(kFigures.size());
  for (const auto& figure : kFigures) names.emplace_back(figure.first);
  app.add_option("--figure", options->figure, "What to draw")->required()->check(CLI::IsMember(names));
  app.add_option("-o,--output", options->out, "The picture (default FOLDER/FIGURE.svg)")->type_name(kFileValue);
  return [options](const CommonOptions&) { return plot(*options); };
}

}  // namespace

Subcommand plot_command() {
  return {.name = "plot",
          .order = 34,
          .summary = "Draw a picture of a run as SVG",
          .details = kPlotDetails,
          .declare = declare_plot};
}

}  // namespace armature::cosim
