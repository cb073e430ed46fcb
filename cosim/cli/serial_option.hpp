// --serial of `armature run`: who is at the other end of the serial line.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cosim/scenario/scenario.hpp"
#include "cosim/serial/host_port.hpp"

namespace armature::cosim {

// The FILE or LINK in `where` (see below); nothing when it has none.
[[nodiscard]] std::optional<std::filesystem::path> file_of_serial(std::string_view where);

// `where` is pty, pty:LINK, tcp:PORT or replay:FILE. A scenario without [serial] gets a line with its defaults. A
// replay sends the characters of the file instead of those of the scenario, and returns no port. Otherwise opens the
// port, prints its name on standard output and returns it. Throws InputError.
[[nodiscard]] std::unique_ptr<HostPort> connect_serial(const std::string& where, Scenario& scenario);

// If `patient`, waits until the client has read the last bytes. Reports lost bytes on standard output.
void finish_serial(HostPort& port, bool patient);

// Removes the serial.csv of an earlier run, so that nobody takes it for one of this run.
void prepare_serial_log(const std::filesystem::path& file);

}  // namespace armature::cosim
