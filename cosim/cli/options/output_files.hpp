// The files that a command reads and writes. A command must not write a file that it reads, must not write one file
// twice, and must not replace anything but a regular file. A command registers all its files before the run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// What happens when the file exists already.
enum class Writing {
  kInPlace,   // opened and written: a device, a pipe or a link is kept
  kReplaced,  // removed or replaced: only a regular file may exist
};

class OutputFiles {
 public:
  // `file` is an input of the command.
  void reads(const std::filesystem::path& file);
  // The scenario, its robot and its golden are inputs of the command.
  void reads(const Scenario& scenario);

  // `file` is an output; `what` names it in messages, such as "--vcd". Throws InputError when the permissions or the
  // folder do not allow to write it, when it would replace something that is no regular file, when it is a folder, a
  // socket or a block device, and when the command reads it or writes it as another output, also through links.
  void writes(const std::filesystem::path& file, const std::string& what, Writing writing);

 private:
  struct Named {
    std::filesystem::path file;
    std::string what;
  };
  std::vector<std::filesystem::path> inputs_;
  std::vector<Named> outputs_;
};

}  // namespace armature::cosim
