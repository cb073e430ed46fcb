#include "tests/controller/app/library/controller_library.hpp"

#include <new>

#include "controller/app/controller.hpp"

namespace armature::test {
namespace {

class Bus final : public RegisterBus {
 public:
  explicit Bus(const BusFunctions& functions) noexcept : to_{functions} {}

  std::uint32_t read32(RegAddr addr) noexcept override { return to_.read32(to_.bus, addr.value); }
  void write32(RegAddr addr, std::uint32_t value) noexcept override { to_.write32(to_.bus, addr.value, value); }
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override {
    return static_cast<Interrupts>(to_.wait_for_interrupt(to_.bus, static_cast<std::uint32_t>(mask)));
  }
  void send_event() noexcept override { to_.send_event(to_.bus); }
  Cycles now() noexcept override { return Cycles{to_.now(to_.bus)}; }
  void charge(Work work, std::int64_t times) noexcept override {
    to_.charge(to_.bus, static_cast<std::uint8_t>(work), times);
  }

 private:
  const BusFunctions& to_;
};

}  // namespace

extern "C" {

[[gnu::visibility("default")]] std::size_t armature_controller_size() {
  return sizeof(Controller);
}

[[gnu::visibility("default")]] void armature_controller_construct(void* controller, void* host_memory) {
  new (controller) Controller{*static_cast<host_memory::HostMemory*>(host_memory)};
}

[[gnu::visibility("default")]] void armature_controller_main(void* controller, int core, const BusFunctions* bus) {
  Bus to{*bus};
  auto& of = *static_cast<Controller*>(controller);
  core == 0 ? of.core0_main(to) : of.core1_main(to);
}

}  // extern "C"

}  // namespace armature::test
