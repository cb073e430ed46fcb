#include <type_traits>

#include "controller/host_memory/layout.hpp"
#include "controller/host_memory/memory.hpp"

namespace armature::host_memory {
namespace {

consteval std::uint64_t computed_layout() {
  LayoutHash hash;
  add_layout(hash, std::type_identity<Command>{});
  add_layout(hash, std::type_identity<Event>{});
  describe<Telemetry>(0, NamePart{}, hash);
  describe<RobotModel>(0, NamePart{}, hash);
  describe<ControllerConfig>(0, NamePart{}, hash);
  describe<ProgramFiles>(0, NamePart{}, hash);
  hash.add(sizeof(HostMemory));
  return hash.value();
}

}  // namespace

// Not in the header: each file that includes it would compute the number again, in a quarter of a second.
std::uint64_t layout_of_memory() noexcept {
  return computed_layout();
}

}  // namespace armature::host_memory
