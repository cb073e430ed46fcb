// The whole co-simulation: chip, plant, two cores, script, invariant and recorder on one clock.
//
// Every component returns the cycle of its next event. Between two events only the chip runs. There is one host thread,
// and no result depends on wall time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "controller/host_memory/boot_memory.hpp"
#include "controller/host_memory/host_side.hpp"
#include "controller/message/event.hpp"
#include "cosim/belt/measured_belt.hpp"
#include "cosim/check/conservation.hpp"
#include "cosim/cpu/processor.hpp"
#include "cosim/cpu/run_ahead.hpp"
#include "cosim/fault/injector.hpp"
#include "cosim/kernel/script/fault_conditions.hpp"
#include "cosim/kernel/script/move_feeder.hpp"
#include "cosim/kernel/script/program_watch.hpp"
#include "cosim/kernel/script/script.hpp"
#include "cosim/kernel/signal.hpp"
#include "cosim/kernel/simulation_state.hpp"
#include "cosim/kernel/software_watch.hpp"
#include "cosim/kernel/wave_window.hpp"
#include "cosim/kernel/whole_ticks.hpp"
#include "cosim/pendant/scripted_pendant.hpp"
#include "cosim/plant/plant.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/serial/serial_line.hpp"
#include "cosim/soc/soc.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// Receives what happens during a run, in the order of simulated time.
class SimulationListener {
 public:
  virtual ~SimulationListener() = default;
  // Once per trigger. The row has no tool point; the listener may set it. Until the next trigger the row changes.
  virtual void on_row(TraceRow& row) = 0;
  virtual void on_event(const Event& event, Cycles now) = 0;           // of the controller
  virtual void on_action(const ScriptAction& action, Cycles now) = 0;  // the scenario is about to do it
  virtual void on_signal(const Signal& signal, Cycles now) = 0;
};

enum class EndReason : std::uint8_t { kFinished, kInterrupted, kFailed };

struct SimulationEnd {
  EndReason reason = EndReason::kFinished;
  std::string failure;           // of kFailed: what went wrong, with tick, axis, cycle, address or core
  std::string_view program_end;  // of kFinished: an unexpected end of the program ended the run early; empty: none did
  std::optional<Cycles> engines_differ_at;  // of kFailed: the engines in lock-step differ from this cycle on
  Cycles cycles{};
  std::int64_t bus_reads = 0;
  std::int64_t bus_writes = 0;
  Cycles worst_tick{};           // longest time core 0 took for one tick, interrupt entry included
  std::int64_t whole_ticks = 0;  // that the engine computed without their edges
  bool wave_written = false;
  std::size_t serial_unsent = 0;  // items that the serial line had not yet sent to the controller
};

class Simulation final : private RunAhead {
 public:
  // `soc` must be at cycle 0. References must outlive the simulation. `peer`: a second sender on the serial line
  // besides the script, if the scenario has a serial line. It replaces the steps of the pendant.
  Simulation(const Scenario& scenario, std::unique_ptr<Soc> soc, SimulationListener& listener,
             std::optional<WaveRequest> wave = std::nullopt, SerialPeer* peer = nullptr);

  // Runs up to the cycle `until`, or to the end of the scenario, or to a failure. What is due in the cycle `until`
  // itself happens in the next call: nothing depends on how a run is cut into calls. Returns false when the run is
  // over. Throws std::runtime_error when a waveform cannot be written.
  bool advance(Cycles until);
  // What is seen of the run at now(). Drives, motors and encoders have done what is due in this cycle; all else that is
  // due happens in the next advance().
  [[nodiscard]] SimulationState look();
  // Replaces the waveform of the constructor, while it is not open. `wave.from` is not before now().
  void write_wave(WaveRequest wave);
  // Completes the file of the waveform if it is open. Throws std::runtime_error when it cannot be written.
  void close_wave() { soc_->close_wave(); }
  // What a core would read of this register of the logic if it began the access now. Time passes and the logic changes:
  // only a copy of this process (cosim/snapshot) may call it, which does not advance the simulation any more.
  [[nodiscard]] BusResponse read_and_spoil(std::uint32_t address);
  // What somebody does to the cell between two calls of advance(), as if the scenario had it. `at_s` is the time of
  // now(), in which it happens at the next advance().
  template <class Action>
  void add(const Action& action) {
    script_.add(action);
  }
  // A set-point of a stream of the scenario, which the caller may have added meanwhile.
  void add(const StreamStep& step) { script_.add(now(), step); }
  // Ends such a fault, or one of the scenario, before its time.
  void end_fault(const FaultSpec& fault) { script_.end(fault, now()); }
  // Of the logic, as of Soc.
  [[nodiscard]] std::vector<Flop> flops() { return soc_->flops(); }
  [[nodiscard]] std::uint64_t logic_digest() { return soc_->digest(); }
  // Of the cores, as of Processor.
  [[nodiscard]] const CoreMemory& core_memory() const { return processor_->memory(); }
  [[nodiscard]] std::optional<std::uint64_t> core_digest() const { return processor_->digest(); }
  // Ends a run that is not over.
  void interrupt();
  [[nodiscard]] Cycles now() const { return soc_->now(); }

  // How the run ended; a run that is not over ends as interrupted. Call it once. The controller does not run
  // afterwards.
  SimulationEnd finish();

 private:
  // RunAhead
  Cycles horizon() const override;
  Cycles pass_time(Cycles until) override;
  bool host_must_read() const override;
  void catch_up(Cycles until) override;
  Outcome try_access(const BusRequest& request, TimeAhead& time) override;

  [[nodiscard]] Cycles horizon_of_others() const;
  void take_fallen_interrupts();
  void show_interrupts();
  void after_fault();
  // Throws InputError if the logic does not have the flop of the fault.
  void require_place(const FaultSpec& fault) const;
  Outcome noticed_access(const BusRequest& request, TimeAhead& time);
  Outcome continue_access(Soc::Progress progress, const BusRequest& request, TimeAhead& time);
  Outcome end_access(const Soc::Progress& progress, const BusRequest& request, TimeAhead& time);

  void step();
  [[nodiscard]] Cycles end() const;
  void move_arm(Cycles until);
  void begin_tick();
  void advance_plant();
  void compute_edges();
  [[nodiscard]] Cycles next_event() const;
  [[nodiscard]] Cycles next_action() const;
  void end_with_program();
  void connect_serial_line(SerialPeer* peer);
  void deliver_due_events();
  void advance_serial();
  void drive_inputs();
  [[nodiscard]] SocInputs inputs() const;
  void act(const ScriptAction& action);
  void take_response();
  void finish_access(BusResponse response);
  // Of an access without an error that has ended at `now`, and has read this. Returns false if it ends the run. There
  // are so many that a call would cost as much as the work.
  [[gnu::always_inline]] bool check_access(const BusRequest& request, std::uint32_t read, Cycles now) {
    if (request.write) {
      ++end_.bus_writes;
      conservation_.on_write(now, request.addr, request.data);
    } else {
      ++end_.bus_reads;
      software_.on_read(read);
      conservation_.on_read(now, request.addr, read);
    }
    if (conservation_.violation()) [[unlikely]]
      fail_conservation();
    return !over_;
  }
  void fail_conservation();
  void check_pulses();
  void grant_bus();
  void give(const CommandSpec& move);
  void feed_program();
  void drop_program(Refusal reason);
  void read_host_memory();
  bool on_pins_changed();
  void report_outputs(std::uint16_t levels);
  void report_servo_enables();
  void publish_belt();
  void on_trigger();
  bool begin_faults_of_conditions();
  [[nodiscard]] std::array<CoreLoad, 2> load_until_now() const;
  void fail(std::string what);

  const Scenario& scenario_;
  SimulationListener& listener_;
  SoftwareWatch software_;  // before the chip, whose waveforms show it
  std::unique_ptr<Soc> soc_;
  host_memory::BootMemory memory_;  // that the host shares with the controller
  std::unique_ptr<Processor> processor_;
  host_memory::HostSide host_;
  Plant plant_;
  Conservation conservation_;
  WholeTicks ticks_;
  Script script_;
  FaultConditions conditions_;
  ProgramWatch program_watch_;
  MoveFeeder program_;
  std::optional<Tag> replacing_;  // the latest joint move that begins at once
  FaultInjector injector_;
  WaveWindow wave_;
  std::optional<MeasuredBelt> belt_;
  std::optional<ScriptedPendant> pendant_;
  std::optional<SerialLine> serial_;
  std::optional<Processor::Access> access_;  // under way
  Cycles access_since_{};
  std::optional<BusResponse> response_;  // of access_; finish_access() is due
  Cycles response_due_{};                // of a response that a fault delays
  bool pins_changed_ = false;            // on_pins_changed() is due
  bool core_was_ahead_ = false;
  std::array<Cycles, 2> bus_time_{};       // of each core, in finished accesses
  std::array<CoreLoad, 2> load_before_{};  // until the latest trigger
  SocOutputs seen_;                        // at the latest change
  std::uint8_t interrupts_ = 0;            // as the processor knows them
  std::uint16_t tool_inputs_ = 0;
  std::uint16_t tool_outputs_ = 0;  // as reported
  bool trigger_was_high_ = false;
  std::uint8_t servo_on_ = 0;  // as reported
  bool servo_was_on_ = false;
  Cycles longest_;  // duration of the scenario
  Cycles until_{};  // of advance()
  bool over_ = false;
  TraceRow row_;  // of the latest trigger, but its telemetry is the latest
  std::int64_t triggers_ = 0;
  SimulationEnd end_;
};

}  // namespace armature::cosim
