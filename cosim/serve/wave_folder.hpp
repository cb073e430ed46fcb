// The only folder in which clients may write waveforms.
#pragma once

#include <filesystem>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

class WaveFolder {
 public:
  // No folder: every file is refused.
  WaveFolder() = default;
  // Creates the folder and the folders above it, if they do not exist. Throws InputError.
  explicit WaveFolder(const std::filesystem::path& folder);

  // Opens a file for writing. Creates it if it does not exist, and does not change its content. `file` is a relative
  // name that ends in .vcd. No part of it may be `..` or a symbolic link, even if another program changes the folder at
  // the same time. An existing file must be a regular file without a second hard link. Throws CommandRefused.
  [[nodiscard]] FileDescriptor open(const std::filesystem::path& file) const;

 private:
  FileDescriptor folder_;
};

}  // namespace armature::cosim
