#include "cosim/cli/options/serial_option.hpp"

#include <fmt/format.h>

#include <iostream>
#include <utility>

#include "cosim/serial/serial_log.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kReplay = "replay:";

// The file also has the characters that the scenario sent. A character may begin in the last cycle of the run.
void replay(const std::filesystem::path& file, Scenario& scenario) {
  auto& sends = scenario.serial_sends;
  const std::string text = read_text_file(file, kMaxTableBytes);
  sends = parse_serial_log(file, text, *scenario.serial);
  scenario.sources.push_back(input_file(file, text));
  const auto late = std::erase_if(sends, [&](const SerialSendSpec& send) { return send.at_s > scenario.duration_s; });
  if (late == 0) return;
  std::cout << fmt::format("serial line    {} characters or breaks of {} come after the end of the run\n", late,
                           printable(file.string(), kShowAll));
}

}  // namespace

std::optional<std::filesystem::path> file_of_serial(std::string_view where) {
  for (const std::string_view kind : {kReplay, std::string_view{"pty:"}}) {
    if (where.starts_with(kind)) return where.substr(kind.size());
  }
  return std::nullopt;
}

std::unique_ptr<HostPort> connect_serial(const std::string& where, Scenario& scenario) {
  if (!scenario.serial) scenario.serial.emplace();
  if (where.starts_with(kReplay)) {
    const std::string file = where.substr(kReplay.size());
    if (file.empty()) throw InputError{"--serial", "expected a file after replay:"};
    replay(file, scenario);
    return nullptr;
  }
  if (where != "pty" && !where.starts_with("pty:") && !where.starts_with("tcp:")) {
    throw InputError{"--serial", "expected pty, pty:LINK, tcp:PORT or replay:FILE, found \"" + where + "\""};
  }
  std::unique_ptr<HostChannel> channel;
  try {
    channel = open_host_channel(where);
  } catch (const InputError& error) {
    throw InputError{"--serial", error.what()};
  }
  auto port = std::make_unique<HostPort>(std::move(channel));
  const SerialSpec& line = *scenario.serial;
  std::cout << fmt::format("serial line    {}, {} baud, {} data bits, parity {}, {} stop bits",
                           printable(port->address(), kShowAll), line.baud, line.data_bits, line.parity,
                           number_text(line.stop_bits))
            << std::endl;  // a client waits for it
  if (const std::string token = port->token(); !token.empty()) std::cout << "token " << token << std::endl;
  return port;
}

void finish_serial(HostPort& port, bool patient) {
  const std::size_t lost = port.lost();
  const std::size_t missing = port.finish(patient ? HostPort::kFinishMs : 0);
  if (missing == 0) return;
  std::cout << fmt::format("serial line    {} bytes of the controller did not reach the client: ", missing);
  if (lost > 0)
    std::cout << fmt::format("{} were lost because the buffer of {} bytes was full, ", lost, HostPort::kBufferBytes);
  std::cout << "the client did not read them\n";
}

void prepare_serial_log(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored))) std::filesystem::remove(file);
}

}  // namespace armature::cosim
