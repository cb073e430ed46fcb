// --serial of `armature run`: the far end of the serial line.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cosim/scenario/scenario.hpp"
#include "cosim/serial/host/host_port.hpp"

namespace armature::cosim {

// The FILE or LINK in `where` (see below). Nothing if `where` has none.
[[nodiscard]] std::optional<std::filesystem::path> file_of_serial(std::string_view where);

// `where` is pty, pty:LINK, tcp:PORT or replay:FILE. A scenario without [serial] gets a line with the default format. A
// replay sends the characters of the file instead of those of the scenario, and returns no port; the caller silences
// the scripted pendant. In the other cases the function opens the port, prints its name on standard output and returns
// it. Throws InputError.
[[nodiscard]] std::unique_ptr<HostPort> connect_serial(const std::string& where, Scenario& scenario);

// If `patient`, waits until the client has read the last bytes. Prints the number of lost bytes on standard output.
void finish_serial(HostPort& port, bool patient);

// Removes the serial.csv of an earlier run, which would look like a result of this run.
void prepare_serial_log(const std::filesystem::path& file);

}  // namespace armature::cosim
