// The files that a command reads and writes: no command writes what it reads, nor one file twice, nor puts a file in
// the place of something else. To be asked before a run, not after it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// How an output is written where something is already.
enum class Writing {
  kInPlace,   // opened and written: a device, a pipe and a link stay what they are
  kReplaced,  // removed or renamed over: only a regular file may be there
};

class OutputFiles {
 public:
  // `file` is an input of the command.
  void reads(const std::filesystem::path& file);
  // The scenario, its robot and its golden are.
  void reads(const Scenario& scenario);

  // `file` is an output; `what` names it in messages, such as "--vcd". Throws InputError when it cannot be written as
  // far as its permissions and its folder tell, when it would replace what is no regular file, when it is a folder, a
  // socket or a block device, and when it is a file that the command reads or writes besides, through whatever links.
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
