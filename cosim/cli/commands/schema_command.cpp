#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/schema/file_kinds.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kSchemaDetails = R"(Examples:
  armature schema scenario > scenario.schema.json
  armature schema robot > robot.schema.json

Prints the JSON Schema (draft 7) of a kind of file, the same as beside the scenarios of the program. An editor for TOML
that knows schemas completes the keys, shows their texts and marks mistakes. The first line of a file names its schema
with a path relative to the file: #:schema scenario.schema.json
Exit code: 0 ok, 2 bad input.)";

CommandAction declare_schema(CLI::App& app) {
  const auto name = std::make_shared<std::string>();
  std::vector<std::string> names;
  names.reserve(kFileKinds.size());
  for (const FileKind& kind : kFileKinds) names.emplace_back(kind.name);
  app.add_option("kind", *name, "The kind of file")->required()->check(CLI::IsMember(names));
  return [name](const CommonOptions&) {
    std::cout << schema_text(*std::ranges::find(kFileKinds, *name, &FileKind::name));
    return kExitOk;
  };
}

}  // namespace

Subcommand schema_command() {
  return {.name = "schema",
          .order = 92,
          .summary = "Print the JSON Schema of scenario or robot files",
          .details = kSchemaDetails,
          .declare = declare_schema};
}

}  // namespace armature::cosim
