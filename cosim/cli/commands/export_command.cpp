#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/recorded_run.hpp"
#include "cosim/exports/mcap_export.hpp"
#include "cosim/exports/npz_export.hpp"
#include "cosim/recording/recorded_program.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExportDetails = R"(Examples:
  armature run draw_line && armature export out/draw_line --mcap line.mcap
  armature export out/draw_line --npz line.npz

Writes the results of a run in formats of other programs.
--mcap is for Foxglove and all that reads MCAP: joint states and set-points, poses of the tool, frames of the links, states,
events, lines of the program, load of the cores. Messages are JSON; angles are in rad, lengths in m, times in simulated time.
--npz is for NumPy: an array for each column of trace.csv and load.csv, with its name and its unit. In Python:
run = numpy.load('line.npz'), then run['time_s'] and run['j1_enc_deg'].
The same results give the same files, byte for byte.
Exit code: 0 ok, 2 bad input, 3 internal error.)";

struct ExportOptions {
  fs::path folder;
  std::optional<fs::path> mcap, npz;
};

// Writes the file by `write(stream)` and names it on standard output.
template <class Write>
void write_file(const fs::path& file, Write write) {
  std::ofstream stream{file, std::ios::binary | std::ios::trunc};
  write(stream);
  stream.close();
  if (!stream) throw InputError{file.string(), "cannot be written"};
  std::cout << printable(file.string(), kShowAll) << '\n';
}

int export_run(const ExportOptions& given) {
  if (!given.mcap && !given.npz) throw InputError{"export", "needs --mcap FILE or --npz FILE"};
  OutputFiles files;
  reads_results(files, given.folder);
  const fs::path load_file = given.folder / kLoadFile;
  files.reads(load_file);
  if (given.mcap) files.writes(*given.mcap, "--mcap", Writing::kInPlace);
  if (given.npz) files.writes(*given.npz, "--npz", Writing::kInPlace);
  const RunRecord run = recorded_run(given.folder);
  const auto load = is_file(load_file) ? std::optional{read_trace_table(load_file)} : std::nullopt;
  if (given.mcap) {
    const auto programs = recorded_programs(run.summary);
    write_file(*given.mcap, [&](std::ostream& out) { export_mcap(out, run, programs, load); });
  }
  if (given.npz) write_file(*given.npz, [&](std::ostream& out) { export_npz(out, run, load); });
  return kExitOk;
}

CommandAction declare_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  app.add_option("folder", options->folder, "Folder with the results of a run")->required()->type_name(kFolderValue);
  app.add_option("--mcap", options->mcap, "Write an MCAP file, for Foxglove")->type_name(kFileValue);
  app.add_option("--npz", options->npz, "Write arrays for NumPy")->type_name(kFileValue);
  return [options](const CommonOptions&) { return export_run(*options); };
}

}  // namespace

Subcommand export_command() {
  return {.name = "export",
          .order = 36,
          .summary = "Write the results of a run for Foxglove or NumPy",
          .details = kExportDetails,
          .declare = declare_export};
}

}  // namespace armature::cosim
