// Writes what is generated from the entries of keys and from the list of facts: tables in the documents beside the
// scenarios, and the JSON Schemas.
//
//   keydoc FOLDER           renews the files in FOLDER, which is scenarios/
//   keydoc --check FOLDER   reports stale files; exit code 1 if there is one
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "cosim/keydoc/markdown.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/schema/file_kinds.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

struct Output {
  fs::path file;
  std::string text;
};

Output document(const fs::path& file, Blocks blocks) {
  return {file, renew_document(read_text_file(file), std::move(blocks), file.string())};
}

std::vector<Output> outputs(const fs::path& folder) {
  std::vector<Output> all{document(folder / "KEYS.md", key_blocks(scenario_file())),
                          document(folder / "robots/KEYS.md", key_blocks(robot_file())),
                          document(folder / "RESULTS.md", fact_blocks())};
  for (const FileKind& kind : kFileKinds) all.push_back({folder / kind.schema, schema_text(kind)});
  return all;
}

bool is_fresh(const Output& output) {
  return fs::exists(output.file) && read_text_file(output.file) == output.text;
}

int run(const std::string& program, const fs::path& folder, bool check) {
  int stale = 0;
  for (const Output& output : outputs(folder)) {
    if (is_fresh(output)) continue;
    ++stale;
    if (check) {
      fmt::print(stderr, "{} is stale; renew it with: {} {}\n", output.file.string(), program, folder.string());
    } else {
      std::ofstream{output.file, std::ios::binary} << output.text;
      fmt::print("wrote {}\n", output.file.string());
    }
  }
  return check && stale > 0 ? 1 : 0;
}

}  // namespace
}  // namespace armature::cosim

int main(int count, char** arguments) {
  const bool check = count == 3 && std::string{arguments[1]} == "--check";
  if (count != (check ? 3 : 2)) {
    fmt::print(stderr, "usage: keydoc [--check] FOLDER\n");
    return 2;
  }
  try {
    return armature::cosim::run(arguments[0], arguments[count - 1], check);
  } catch (const armature::cosim::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
