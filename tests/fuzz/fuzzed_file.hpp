// A file in memory whose content the fuzzer changes, for loaders that read files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace armature::cosim::test {

class FuzzedFile {
 public:
  // `name` is relative to a new folder, which is removed at the end.
  explicit FuzzedFile(const std::filesystem::path& name) {
    const bool in_memory = std::filesystem::is_directory("/dev/shm");
    std::string folder = (in_memory ? std::filesystem::path{"/dev/shm"} : std::filesystem::temp_directory_path()) /
                         "armature_fuzz_XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) std::abort();
    folder_ = folder;
    path_ = folder_ / name;
    std::filesystem::create_directories(path_.parent_path());
  }
  FuzzedFile(const FuzzedFile&) = delete;
  FuzzedFile& operator=(const FuzzedFile&) = delete;
  ~FuzzedFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  void write(const std::uint8_t* data, std::size_t size) const {
    std::ofstream stream{path_, std::ios::binary | std::ios::trunc};
    stream.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    if (!stream) std::abort();
  }

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

}  // namespace armature::cosim::test
