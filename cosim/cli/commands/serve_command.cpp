#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/logic_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/engine/make_soc.hpp"
#include "cosim/net/listener.hpp"
#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/served_soc.hpp"
#include "cosim/serve/server.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kServeDetails = R"(Examples:
  armature serve --listen /tmp/arm_soc.sock --out waves
  python3 cosim/serve/client/timer_self_test.py /tmp/arm_soc.sock
  printf 'w 0x42800004 2498\nw 0x42800000 0x20\nw 0x42800000 0xD2\nrun-until-irq 5000\npin irq_o\n' |
    nc -N -U /tmp/arm_soc.sock        # nc of netcat-openbsd
Over TCP the first line of a client is 'token TOKEN', with the token that the server prints when it starts:
  (umask 077; exec armature serve --listen tcp:5025 --variant paper > serve.txt) &
  sleep 1; export ARMATURE_TOKEN=$(sed -n 's/^token //p' serve.txt)
  python3 cosim/serve/client/timer_self_test.py tcp:5025
  printf "token $ARMATURE_TOKEN\ntime\n" | nc -N 127.0.0.1 5025

A client sends one command in each line. It gets one line as the answer to each, in order: ok, ok 0xVALUE, ok CYCLE or
error WHAT.
  r ADDR               w ADDR DATA [STRB]    run CYCLES    run-until-irq MAX
  pin NAME [VALUE]     time                  vcd [FILE]    help [COMMAND]    batch OPERATION; ...
Numbers are decimal or 0x... A client may send many commands before it reads the first answer. Simulated time passes
only in r, w, run and run-until-irq, so the same commands give the same cycles and values. There are no controller and
no drives.
TCP is reachable from this machine only, a socket file by its user only. The server removes the socket file at its end.
It accepts one client at a time. A second client gets 'error busy: ...', and its connection is closed. The logic keeps
its state from one client to the next. vcd FILE writes below the folder of --out only. cosim/serve/README.md describes
the protocol. cosim/serve/client has clients in C and Python, which read the token from ARMATURE_TOKEN.
Ctrl-C ends the server and closes the waveform.
Exit code: 130 interrupted, 1 a check inside the logic failed, 2 bad input, 3 internal error.)";

struct ServeOptions {
  std::string listen;                        // tcp:PORT, or the path of a Unix socket
  std::optional<std::filesystem::path> out;  // folder for waveforms; nullopt: clients may write none
  LogicChoice logic;
};

std::unique_ptr<Listener> listen_at(const std::string& where) try {
  return std::make_unique<Listener>(parse_listen_address(where));
} catch (const InputError& error) {
  const Problem& problem = error.problems().front();
  throw InputError{"--listen " + problem.file, problem.message};
}

// Serves until Ctrl-C, then returns kExitInterrupted. Returns kExitCheckFailed if an assertion inside the logic failed.
int serve_clients(const ServeOptions& given) {
  catch_interrupts();
  const std::unique_ptr<Listener> listener = listen_at(given.listen);
  const Scenario defaults;
  ServedSoc soc{make_soc(given.logic.variant.value_or(defaults.variant), given.logic.engine.value_or(defaults.engine),
                         defaults.bus, defaults.seed)};
  Interpreter interpreter{soc, given.out ? WaveFolder{*given.out} : WaveFolder{}};
  // Scripts wait for these lines. A client must send the second one first.
  std::string lines = fmt::format("listening on {}\n", listener->name());
  if (listener->token()) lines += fmt::format("token {}\n", *listener->token());
  std::cout << lines << std::flush;
  const std::int64_t clients = serve(*listener, interpreter, interrupted);
  soc.close_wave();
  std::cout << fmt::format("{} lines of {} clients answered, cycle {}\n", interpreter.lines(), clients,
                           soc.now().value());
  return interpreter.broken() ? kExitCheckFailed : kExitInterrupted;
}

CommandAction declare_serve(CLI::App& app) {
  const auto options = std::make_shared<ServeOptions>();
  app.add_option("--listen", options->listen, "Path of a Unix socket, or tcp:PORT (0: any free one, printed)")
      ->required();
  app.add_option("--out", options->out, "Folder for the waveforms of vcd FILE (default: none, vcd FILE is refused)")
      ->type_name(kFolderValue);
  add_logic_options(app, options->logic);
  return [options](const CommonOptions&) { return serve_clients(*options); };
}

}  // namespace

Subcommand serve_command() {
  return {.name = "serve",
          .order = 70,
          .summary = "Let other programs drive the bus and the pins of the logic",
          .details = kServeDetails,
          .declare = declare_serve};
}

}  // namespace armature::cosim
