#include "cosim/kernel/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/kernel/boot_text.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

// By BusError.
constexpr std::array kBusErrorTexts{"ok", "the slave answered SLVERR", "no slave at this address (DECERR)",
                                    "no answer within the time-out"};
static_assert(kBusErrorTexts.size() == kBusErrorNames.size());

std::optional<Cycles> drop_out(const Scenario& scenario) {
  if (!scenario.drop_out_us) return std::nullopt;
  return to_cycles(*scenario.drop_out_us * 1e-6);
}

}  // namespace

Simulation::Simulation(const Scenario& scenario, std::unique_ptr<Soc> soc, SimulationListener& listener,
                       std::optional<WaveRequest> wave, SerialPeer* peer)
    : scenario_{scenario},
      listener_{listener},
      software_{scenario},
      soc_{std::move(soc)},
      memory_(to_boot_memory(scenario)),
      processor_{make_processor(memory_.memory(), scenario.cpu)},
      host_{memory_.memory()},
      plant_{scenario.robot, drop_out(scenario), scenario.unreferenced_start_deg.value_or(PerAxis<double>{})},
      conservation_{
          plant_, scenario.bus, {.paper = scenario.variant == Variant::kPaper, .input_jitter = scenario.input_jitter}},
      ticks_{*soc_, plant_, conservation_},
      script_{scenario},
      conditions_{scenario},
      program_watch_{scenario, script_},
      injector_{{.plant = plant_, .processor = *processor_, .soc = *soc_}, scenario.seed},
      wave_{std::move(wave)},
      longest_{to_cycles(scenario.duration_s)} {
  processor_->run_ahead(*this);
  soc_->add_to_waves(software_.signals());
  if (scenario.conveyor) {
    belt_.emplace(*scenario.conveyor);
    if (scenario.conveyor->camera) camera_.emplace(*scenario.conveyor->camera, scenario.seed);
    if (!camera_) host_.publish_belt(belt_counts());
  }
  if (scenario.serial) connect_serial_line(peer);
  drive_inputs();
}

void Simulation::connect_serial_line(SerialPeer* peer) {
  if (scenario_.pendant && peer == nullptr) {
    const auto log = [this](const std::string& text) { listener_.on_signal(PendantStepDone{text}, now()); };
    peer = &pendant_.emplace(*scenario_.pendant, scenario_.robot, scenario_.seed, log);
  }
  serial_.emplace(
      SerialFormat::from(*scenario_.serial), to_script(scenario_.serial_sends),
      [this](const SerialEvent& event) {
        software_.on_serial(event);
        listener_.on_signal(event, now());
      },
      peer);
}

bool Simulation::advance(Cycles until) {
  until_ = until;
  try {
    while (!over_ && now() < until_) step();
  } catch (const LogicCheckFailed& failed) {
    fail(fmt::format("a check inside the logic failed at cycle {} (message above)", failed.cycle.value()));
  } catch (const EnginesDiffer& difference) {
    end_.engines_differ_at = difference.cycle;
    fail(fmt::format("the engines differ at cycle {}: {}", difference.cycle.value(), difference.what));
  }
  return !over_;
}

// All that happens in this cycle, then the time up to the next event.
void Simulation::step() {
  if (std::exchange(pins_changed_, false)) on_pins_changed();
  deliver_due_events();
  const Cycles here = now(), end = this->end();
  over_ = over_ || here >= end;
  if (over_) return;
  // In that cycle the core waits for something that is due.
  const bool was_ahead = std::exchange(core_was_ahead_, false);
  if (was_ahead && (pins_changed_ || response_ || soc_->has_response() || processor_->next_event() <= here)) return;
  const Cycles next = std::clamp(next_event(), here + Cycles{1}, std::min(end, until_));
  if (wave_.is_open()) software_.show(*processor_, access_, triggers_ - 1, row_.telemetry.state);
  move_arm(next);
}

// Runs to `until`, or until something happens that concerns more than pulses, drives and encoders.
void Simulation::move_arm(Cycles until) {
  for (Cycles here = now();;) {
    const Cycles next = std::clamp(std::min(plant_.next_event(), ticks_.next_event()), here + Cycles{1}, until);
    const bool others = soc_->advance(next, StopOn::kPinChange) && on_pins_changed();
    begin_tick();
    here = now();
    if (others || core_was_ahead_ || over_ || here >= until || soc_->has_response()) return;
    if (plant_.next_event() <= here) advance_plant();
    if (over_) return;
  }
}

// Or computes the edges of one that has no end, if this is due.
void Simulation::begin_tick() {
  const Cycles here = now();
  if (ticks_.next_event() > here) return;
  if (ticks_.advance(here, !wave_.is_open() && injector_.is_quiet())) drive_inputs();
}

void Simulation::advance_plant() {
  plant_.advance(now());
  drive_inputs();
  report_servo_enables();
  if (const auto& violation = plant_.violation()) fail(describe(*violation));
}

// From now on, and up to now, because something asks for the edges of the tick.
void Simulation::compute_edges() {
  if (ticks_.leave(now())) drive_inputs();
}

void Simulation::write_wave(WaveRequest wave) {
  wave_ = WaveWindow{std::move(wave)};
}

BusResponse Simulation::read_and_spoil(std::uint32_t address) {
  compute_edges();
  const auto end_of_access = [this] {
    while (!soc_->has_response()) soc_->advance(now() + soc_->access_timeout(), StopOn::kAccess);
    return soc_->pop_response().value();
  };
  if (!soc_->idle()) end_of_access();  // of a core
  soc_->start({.write = false, .addr = address});
  return end_of_access();
}

void Simulation::interrupt() {
  if (over_) return;
  over_ = true;
  end_.reason = EndReason::kInterrupted;
}

SimulationEnd Simulation::finish() {
  interrupt();
  soc_->close_wave();
  conservation_.finish();
  end_with_program();
  if (conservation_.violation()) fail_conservation();
  if (pendant_ && end_.reason == EndReason::kFinished) {
    if (const auto unfinished = pendant_->unfinished()) fail(*unfinished);
  }
  end_.cycles = now();
  if (serial_) end_.serial_unsent = serial_->unsent();
  end_.worst_tick = processor_->worst_tick(now());
  end_.whole_ticks = ticks_.ticks();
  end_.wave_written = wave_.was_open();
  return end_;
}

// Says why the run ended before its duration, or that its program did not end.
void Simulation::end_with_program() {
  if (end_.reason != EndReason::kFinished) return;
  const std::optional<Cycles> end = program_watch_.end();
  if (end && now() >= *end) {
    end_.program_end = program_watch_.unexpected();
  } else if (scenario_.ends_with_program) {
    fail(fmt::format("the program is not over after {} s, the longest run without duration_s", scenario_.duration_s));
  }
}

Cycles Simulation::end() const {
  return std::min(longest_, program_watch_.end().value_or(longest_));
}

// Of everything but the logic and the plant.
Cycles Simulation::next_event() const {
  return std::min(processor_->next_event().value_or(kNever), next_action());
}

// Of everything but the chip and the plant.
Cycles Simulation::next_action() const {
  Cycles next = kNever;
  const auto consider = [&next](std::optional<Cycles> event) {
    if (event && *event < next) next = *event;
  };
  consider(script_.next_event());
  consider(wave_.next_event());
  consider(injector_.next_event());
  if (response_ && response_due_ > now()) consider(response_due_);
  if (serial_) consider(serial_->next_event());
  return next;
}

void Simulation::deliver_due_events() {
  const Cycles here = now();
  if (const auto next = wave_.next_event(); next && *next <= here) compute_edges();
  wave_.advance(here, *soc_);
  if (plant_.next_event() <= here) advance_plant();
  while (const auto action = script_.pop_due(now())) act(*action);
  if (injector_.next_event() <= now()) {
    injector_.advance(now());
    drive_inputs();
  }
  if (serial_) advance_serial();
  take_response();
  processor_->advance(now());
  read_host_memory();
  feed_program();
  if (soc_->idle() && !access_) grant_bus();
}

// Ends the access whose response has come, if no fault delays it.
void Simulation::take_response() {
  if (!response_) {
    response_ = soc_->pop_response();
    response_due_ = now() + injector_.response_delay();
  }
  if (!response_ || response_due_ > now()) return;
  finish_access(*std::exchange(response_, std::nullopt));
}

void Simulation::advance_serial() {
  const std::optional<Cycles> next = serial_->next_event();
  if (!next || *next > now()) return;
  const bool rxd = serial_->rxd();
  serial_->advance(now());
  if (pendant_ && pendant_->failure()) fail(*pendant_->failure());
  if (serial_->rxd() != rxd) drive_inputs();
}

void Simulation::drive_inputs() {
  soc_->set_inputs(inputs());
}

SocInputs Simulation::inputs() const {
  SocInputs inputs = plant_.inputs();
  if (serial_) inputs.uart_rxd = serial_->rxd();
  inputs.gpio = tool_inputs_;
  injector_.apply_to(inputs);
  return inputs;
}

void Simulation::finish_access(BusResponse response) {
  bus_time_.at(static_cast<std::size_t>(access_->core)) += now() - access_since_;
  const Processor::Access access = *std::exchange(access_, std::nullopt);
  const BusRequest& request = access.request;
  if (injector_.takes_for_error(request.addr)) {
    // The fault spoils the response of an access that the logic has executed.
    if (request.write && response.error == BusError::kNone) conservation_.on_write(now(), request.addr, request.data);
    response = {.error = BusError::kSlaveError, .data = 0};
  }
  if (response.error != BusError::kNone && (access.stray || injector_.explains_bus_errors())) {
    processor_->abort(access, now());
    listener_.on_signal(BusAbort{.access = access, .error = response.error}, now());
    return;
  }
  if (response.error != BusError::kNone) {
    fail(fmt::format("bus: {} at 0x{:08X} by core {}: {} (cycle {})", request.write ? "write" : "read", request.addr,
                     access.core, kBusErrorTexts.at(static_cast<std::size_t>(response.error)), now().value()));
    return;
  }
  if (!check_access(request, response.data, now())) return;
  processor_->complete(access, response, now());
  read_host_memory();
}

void Simulation::fail_conservation() {
  fail(*conservation_.violation());
}

// One access at a time.
void Simulation::grant_bus() {
  access_ = processor_->next_access();
  if (!access_) return;
  if (ticks_.disturbs(access_->request)) compute_edges();
  access_since_ = now();
  soc_->start(access_->request);
}

// Called whenever a core has run, so everything that the controller has written since the last call happened in this
// cycle.
void Simulation::read_host_memory() {
  if (!host_.has_news()) return;
  while (const std::optional<Event> event = host_.next_event()) {
    const auto* refused = std::get_if<MoveRefused>(&*event);
    if (const auto index = refused == nullptr ? std::nullopt : move_index(refused->tag)) program_.on_refused(*index);
    listener_.on_event(*event, now());
    software_.on_event(*event);
    if (const auto* started = std::get_if<MoveStarted>(&*event)) {
      if (const auto index = move_index(started->tag)) conditions_.on_move(*index);
    }
    if (const auto* note = std::get_if<ProgramNoted>(&*event)) program_watch_.on_note(*note, now());
    if (std::holds_alternative<Faulted>(*event)) drop_program(Refusal::kNotReady);
    if (refused != nullptr && refused->reason == Refusal::kPartLost) drop_program(Refusal::kPartLost);
    if (const auto* started = std::get_if<MoveStarted>(&*event); started != nullptr && started->tag == replacing_) {
      drop_program(Refusal::kReplaced);
    }
  }
  host_.read_new(row_.telemetry);  // the controller does not run meanwhile
  if (const host_memory::BootReport* report = host_.boot_problem()) fail(boot_text(*report));
  if (host_.lost_events() != 0) fail("the host memory of the controller had no room for an event");
}

// Returns whether a pin has changed that concerns more than the plant.
bool Simulation::on_pins_changed() {
  const SocOutputs& out = soc_->outputs();
  SocOutputs others = std::exchange(seen_, out);
  others.step = out.step;
  others.dir = out.dir;
  others.heartbeat = out.heartbeat;
  if (!wave_.is_open()) others.trigger = out.trigger;  // a waveform shows the number of the tick
  const bool triggers = out.trigger && !trigger_was_high_;
  const Cycles here = now();
  if (triggers && ticks_.on_trigger(here)) drive_inputs();
  plant_.on_outputs(here, out);
  conservation_.on_outputs(here, out);
  if (serial_) serial_->on_level(here, out.uart_txd);
  if (const auto& violation = plant_.violation()) fail(describe(*violation));
  if (out.gpio != tool_outputs_) report_outputs(out.gpio);
  report_servo_enables();
  if (triggers) on_trigger();
  trigger_was_high_ = out.trigger;
  const bool faults_begin = triggers && begin_faults_of_conditions();
  const bool concern_others = faults_begin || others != out;
  show_interrupts();
  return concern_others;
}

// Tells the processor the interrupt levels, if they have changed.
void Simulation::show_interrupts() {
  const std::uint8_t levels = injector_.seen_interrupts(seen_.irq);
  if (levels == interrupts_) return;
  begin_tick();  // the core that wakes may run ahead in it
  processor_->set_interrupts(interrupts_ = levels, now());
  read_host_memory();
}

void Simulation::report_servo_enables() {
  const std::uint8_t levels = plant_.servo_enables();
  if (levels != servo_on_) listener_.on_signal(ServoEnables{servo_on_ = levels}, now());
}

std::int64_t Simulation::belt_counts() const {
  return belt_->counts(to_seconds(now()));
}

// The count of the encoder in each tick; of a camera, a sample when it arrives.
void Simulation::publish_belt() {
  if (!camera_) return host_.publish_belt(belt_counts());
  const std::optional<std::int64_t> sample = camera_->arriving(triggers_);
  if (!sample) return;
  host_.publish_belt(belt_->counts(to_seconds(now()) - camera_->dead_time_s(), camera_->noise_mm(*sample)));
}

void Simulation::report_outputs(std::uint16_t levels) {
  for (unsigned changed = levels ^ std::exchange(tool_outputs_, levels); changed != 0; changed &= changed - 1) {
    const int bit = std::countr_zero(changed);
    listener_.on_signal(OutputLevel{.pin = bit + 1, .level = ((levels >> bit) & 1) != 0}, now());
  }
}

void Simulation::on_trigger() {
  const Cycles here = now();
  conservation_.on_trigger(here);
  if (conservation_.violation()) fail_conservation();
  if (belt_) publish_belt();
  // The time before the first trigger was start-up, not a tick.
  if (triggers_ == 0) processor_->reset_worst_tick();

  const std::uint8_t servo_on = soc_->outputs().servo_on;
  row_.tick = triggers_++;
  row_.cycle = here.value();
  row_.stopped = servo_was_on_ && servo_on == 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    row_.pin_pulses[axis] = conservation_.pin_pulses(axis);
    row_.pulses_to_drop[axis] = plant_.pulses_to_drop(axis);
    row_.motor_counts[axis] = plant_.motor_counts(axis).value();
    row_.first_rise[axis] = conservation_.edges_of_tick(axis).first_rise.value();
    row_.turned[axis] = conservation_.edges_of_tick(axis).turned.value();
    const Plant::MotorStep motor = plant_.motor_step_before(axis, here);
    row_.motor_from[axis] = motor.start.value();
    row_.motor_to[axis] = motor.target.value();
  }
  row_.load_lead_deg = plant_.load_lead_deg();
  const std::array<CoreLoad, 2> load = load_until_now();
  for (std::size_t core = 0; core < load.size(); ++core) {
    row_.load[core] = {.awake_cycles = load[core].awake_cycles - load_before_[core].awake_cycles,
                       .bus_cycles = load[core].bus_cycles - load_before_[core].bus_cycles,
                       .instructions = load[core].instructions - load_before_[core].instructions};
  }
  load_before_ = load;
  servo_was_on_ = servo_was_on_ || servo_on != 0;
  row_.tool_point.reset();
  listener_.on_row(row_);
}

// They begin in the next cycle, as any other action of the script.
bool Simulation::begin_faults_of_conditions() {
  const std::vector<FaultSpec> due = conditions_.due(row_);
  for (const FaultSpec& fault : due) script_.insert(now() + Cycles{1}, fault);
  return !due.empty();
}

// Since the beginning of the run.
std::array<CoreLoad, 2> Simulation::load_until_now() const {
  std::array<CoreLoad, 2> load;
  const Cycles here = now();
  for (std::size_t core = 0; core < load.size(); ++core) {
    const bool on_bus = access_ && access_->core == static_cast<int>(core);
    load[core].awake_cycles = processor_->awake(static_cast<int>(core), here).value();
    load[core].instructions = processor_->instructions(static_cast<int>(core));
    load[core].bus_cycles = (bus_time_[core] + (on_bus ? here - access_since_ : Cycles{})).value();
  }
  return load;
}

void Simulation::fail(std::string what) {
  if (end_.reason == EndReason::kFailed) return;  // the first cause is the one to report
  end_.reason = EndReason::kFailed;
  end_.failure = std::move(what);
  over_ = true;
}

}  // namespace armature::cosim
