#include "cosim/kernel/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/cpu/make_processor.hpp"
#include "cosim/kernel/boot_text.hpp"
#include "cosim/scenario/to_controller.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::optional<Cycles> drop_out(const Scenario& scenario) {
  if (!scenario.drop_out_us) return std::nullopt;
  return to_cycles(*scenario.drop_out_us * 1e-6);
}

PerAxis<double> start_deg(const Scenario& scenario) {
  return scenario.unreferenced_start_deg.value_or(scenario.moved_start_deg.value_or(PerAxis<double>{}));
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
      plant_{scenario.robot, drop_out(scenario), start_deg(scenario)},
      conservation_{
          plant_, scenario.bus, {.paper = scenario.variant == Variant::kPaper, .input_jitter = scenario.input_jitter}},
      ticks_{*soc_, plant_, conservation_},
      script_{scenario},
      conditions_{scenario},
      program_watch_{scenario, script_},
      injector_{{.plant = plant_, .processor = *processor_, .soc = *soc_}, scenario.seed},
      wave_{std::move(wave)},
      longest_{to_cycles(scenario.duration_s)} {
  for (const FaultSpec& fault : scenario.faults) require_place(fault);
  processor_->run_ahead(*this);
  soc_->add_to_waves(software_.signals());
  if (scenario.conveyor) {
    belt_.emplace(*scenario.conveyor, scenario.seed);
    if (!scenario.conveyor->camera) publish_belt();  // an encoder has a count before the first tick
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
  if (ticks_.advance(here, !wave_.is_open() && injector_.leaves_ticks_alone())) drive_inputs();
}

void Simulation::advance_plant() {
  plant_.advance(now());
  drive_inputs();
  report_servo_enables();
  check_pulses();
}

// A logic with a flipped flop may emit a pulse that is too short.
void Simulation::check_pulses() {
  const auto& violation = plant_.violation();
  if (violation && !injector_.has_flipped_flops()) fail(describe(*violation));
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

void Simulation::fail(std::string what) {
  if (end_.reason == EndReason::kFailed) return;  // the first cause is the one to report
  end_.reason = EndReason::kFailed;
  end_.failure = std::move(what);
  over_ = true;
}

}  // namespace armature::cosim
