#include <fmt/format.h>

#include <iostream>

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
  ServedSoc soc{make_verilated_fabric(arguments.paper_fabric ? FabricKind::kPaper : FabricKind::kRtl), {}, interrupted};
  Interpreter interpreter{soc};
  // Scripts wait for this line.
  std::cout << "listening on " << listener.name() << std::endl;
  const std::int64_t clients = serve(listener, interpreter, interrupted);
  soc.fabric().close_wave();
  std::cout << fmt::format("{} lines of {} clients answered, cycle {}\n", interpreter.lines(), clients,
                           soc.now().value());
  return interpreter.broken() ? kExitCheckFailed : kExitInterrupted;
}

}  // namespace armature::cosim
