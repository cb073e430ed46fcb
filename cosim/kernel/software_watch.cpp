#include "cosim/kernel/software_watch.hpp"

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "controller/base/overloaded.hpp"
#include "cosim/fabric/register_table.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

using enum SoftwareSignal;

// By CoreState.
constexpr std::array<std::string_view, 4> kCoreStateNames{"waiting", "computing", "bus", "halted"};

constexpr std::string_view name_of(CoreState state) {
  return kCoreStateNames[static_cast<std::size_t>(state)];
}
static_assert(name_of(CoreState::kHalted) == "halted");

SerialBurst burst_of(const Scenario& scenario, SoftwareSignal signal) {
  const SerialFormat format = scenario.serial ? SerialFormat::from(*scenario.serial) : SerialFormat{};
  return {format, SoftwareSignals::characters(signal)};
}

}  // namespace

SoftwareWatch::SoftwareWatch(const Scenario& scenario)
    : variant_{scenario.variant},
      names_{scenario},
      serial_in_{burst_of(scenario, kSerialIn)},
      serial_out_{burst_of(scenario, kSerialOut)} {}

void SoftwareWatch::on_event(const Event& event) {
  std::visit(Overloaded{
                 [this](const MoveStarted& move) { begin(move_name(move), move.tag); },
                 [this](const MoveFinished& move) { end(move.tag); },
                 [this](const JogStarted& jog) { begin("jog", jog.tag); },
                 [this](const JogEnded& jog) { end(jog.tag); },
                 [this](const HomingStarted& axis) {
                   ++homing_axes_;
                   begin("homing", axis.tag);
                 },
                 [this](const HomingEnded& axis) {
                   if (--homing_axes_ == 0) end(axis.tag);
                 },
                 [this](const Faulted& fault) {
                   if (std::exchange(faulted_, true)) return;
                   signals_.set(kFault, word_of(fault.cause));
                   signals_.set(kFaultAxis, fault.axis);
                 },
                 [this](const ProgramNoted& note) {
                   if (note.kind == ProgramNoted::Kind::kOver) return;
                   const bool ended = note.kind == ProgramNoted::Kind::kEnded;
                   signals_.set(kProgram, ended ? std::string{} : names_.line_text(note.place));
                 },
                 [](const auto&) {},
             },
             event);
}

void SoftwareWatch::on_serial(const SerialEvent& event) {
  const bool is_in = event.direction == SerialDirection::kRx;
  (is_in ? serial_in_ : serial_out_).add(event);
  serial_changed_ = true;
}

void SoftwareWatch::begin(std::string_view type, Tag tag) {
  moving_ = tag;
  signals_.set(kMove, names_.of(tag));
  signals_.set(kMoveType, type);
}

// On a corner the next move has begun.
void SoftwareWatch::end(Tag tag) {
  if (moving_ != tag) return;
  moving_.reset();
  signals_.set(kMove, "");
  signals_.set(kMoveType, "");
}

void SoftwareWatch::show(const Processor& processor, const std::optional<Processor::Access>& access, std::int64_t tick,
                         MotionState state) {
  signals_.set(kTick, static_cast<std::uint32_t>(tick));
  signals_.set(kMotion, word_of(state));
  signals_.set(kCore0, name_of(processor.core_state(0)));
  signals_.set(kCore1, name_of(processor.core_state(1)));
  signals_.set(kBusBusy, access ? 1u : 0u);
  signals_.set(kBusReadData, read_data_);
  if (std::exchange(serial_changed_, false)) {
    signals_.set(kSerialIn, serial_in_.text());
    signals_.set(kSerialOut, serial_out_.text());
  }
  if (access) show_access(*access);
}

void SoftwareWatch::show_access(const Processor::Access& access) {
  const BusRequest& request = access.request;
  signals_.set(kBusCore, static_cast<std::uint32_t>(access.core));
  signals_.set(kBusWrite, request.write ? 1u : 0u);
  signals_.set(kBusAddress, request.addr);
  signals_.set(kBusRegister, register_name(variant_, request.addr));
  if (request.write) signals_.set(kBusWriteData, request.data);
}

}  // namespace armature::cosim
