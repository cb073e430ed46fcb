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

// What `where` names below: FILE or LINK; nothing when it names none.
[[nodiscard]] std::optional<std::filesystem::path> file_of_serial(std::string_view where);

// `where` is pty, pty:LINK, tcp:PORT or replay:FILE. A scenario without [serial] gets a line with its defaults. A
// replay sends what the file says instead of what the scenario does; otherwise the port is opened, told on standard
// output and returned. Throws InputError.
[[nodiscard]] std::unique_ptr<HostPort> connect_serial(const std::string& where, Scenario& scenario);

// Waits for the client to take the last bytes, `patient` only, and tells on standard output when some were lost.
void finish_serial(HostPort& port, bool patient);

// A serial.csv of an earlier run must not be taken for one of this run.
void prepare_serial_log(const std::filesystem::path& file);

}  // namespace armature::cosim
