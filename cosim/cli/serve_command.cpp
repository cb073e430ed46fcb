#include <fmt/format.h>

#include <iostream>
#include <string>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/interrupt.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/listener.hpp"
#include "cosim/serve/served_soc.hpp"
#include "cosim/serve/server.hpp"

namespace armature::cosim {

int serve_command(const ServeArguments& arguments) {
  catch_interrupts();
  Listener listener{parse_listen_address(arguments.listen)};
  ServedSoc soc{make_verilated_fabric(arguments.paper_fabric ? FabricKind::kPaper : FabricKind::kRtl)};
  Interpreter interpreter{soc, arguments.out ? WaveFolder{*arguments.out} : WaveFolder{}};
  // Scripts wait for these lines; the second is what a client has to say first.
  std::string lines = fmt::format("listening on {}\n", listener.name());
  if (listener.token()) lines += fmt::format("token {}\n", *listener.token());
  std::cout << lines << std::flush;
  const std::int64_t clients = serve(listener, interpreter, interrupted);
  soc.fabric().close_wave();
  std::cout << fmt::format("{} lines of {} clients answered, cycle {}\n", interpreter.lines(), clients,
                           soc.now().value());
  return interpreter.broken() ? kExitCheckFailed : kExitInterrupted;
}

}  // namespace armature::cosim
