// The folder for the results of a run. One run at a time may use it.
//
// During a run the folder holds the file `unfinished`, which is locked, names the process and has the summary of a run
// that has not begun. The run removes it at its end. A process that is killed, or fails, leaves the file without a
// lock: it marks the results beside it as those of a run that did not reach its end, and tells what run it was.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {

// The files that a run writes there; scenarios/RESULTS.md describes them.
inline constexpr const char* kTraceFile = "trace.csv";
inline constexpr const char* kLoadFile = "load.csv";
inline constexpr const char* kLogFile = "log.txt";
inline constexpr const char* kSerialFile = "serial.csv";  // of a scenario with a serial line
inline constexpr const char* kSummaryFile = "summary.json";
inline constexpr std::array kResultFiles{kTraceFile, kLoadFile, kLogFile, kSerialFile, kSummaryFile};

// Creates the folder if it is missing. Throws InputError when it cannot be created.
void create_folder(const std::filesystem::path& folder);

class RunFolder {
 public:
  // Creates the folder if it is missing, and locks it. Throws InputError when the folder cannot be created or written,
  // and when another run has the lock. The message then names that process.
  explicit RunFolder(std::filesystem::path folder);
  // Releases the lock. Without finish() the mark stays.
  ~RunFolder() = default;
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  // Writes the summary into the mark. Throws InputError when that is not possible.
  void describe(const std::string& summary);
  // Called when all results are written. Removes the mark.
  void finish();

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

 private:
  void write_mark(const std::string& summary);

  std::filesystem::path folder_;
  FileDescriptor mark_;
};

// Whether a run is writing into this folder now. On a file system without locks: false.
[[nodiscard]] bool is_being_written(const std::filesystem::path& folder);

// Why the results in this folder are not complete, in words that fit each of its files. Nothing if there is no mark.
[[nodiscard]] std::optional<std::string> why_unfinished(const std::filesystem::path& folder);

// The summary in the mark of a folder that has one; may be empty. Throws InputError when it cannot be read.
[[nodiscard]] std::string unfinished_summary(const std::filesystem::path& folder);

}  // namespace armature::cosim
