// The folder in which clients may write waveforms, and nowhere else.
#pragma once

#include <filesystem>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

class WaveFolder {
 public:
  // None: every file is refused.
  WaveFolder() = default;
  // Makes the folder, if there is none, and those above it. Throws InputError.
  explicit WaveFolder(const std::filesystem::path& folder);

  // Opens a file for writing; makes it when there is none, and leaves its content alone. `file` is a relative name that
  // ends in .vcd. No part of it may be `..` or a symbolic link, also not while somebody changes the folder. What
  // exists must be a plain file without a second name. Throws CommandRefused.
  [[nodiscard]] FileDescriptor open(const std::filesystem::path& file) const;

 private:
  FileDescriptor folder_;
};

}  // namespace armature::cosim
