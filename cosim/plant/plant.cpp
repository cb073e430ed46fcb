#include "cosim/plant/plant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "cosim/plant/counts_per_rev.hpp"
#include "cosim/plant/make_mechanics.hpp"

namespace armature::cosim {

Plant::Plant(const RobotSpec& robot, std::optional<Cycles> drop_out, const PerAxis<double>& start_deg)
    : Plant{robot, make_mechanics(robot), drop_out, start_deg} {}

Plant::Plant(const RobotSpec& robot, std::unique_ptr<Mechanics> mechanics, std::optional<Cycles> drop_out,
             const PerAxis<double>& start_deg)
    : mechanics_{std::move(mechanics)} {
  if (drop_out) drop_out_.emplace(*drop_out);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisSpec& spec = robot.axes[axis];
    const double deg_per_count = 360.0 / (spec.gear_ratio * 4.0 * static_cast<double>(spec.encoder_lines));
    const Counts start{std::llround(start_deg[axis] / deg_per_count)};
    drives_.emplace_back(axis, spec, start);
    encoders_.emplace_back(counts_per_rev(spec), start);
    switches_.emplace_back(spec, deg_per_count);
    joint_deg_per_count_[axis] = deg_per_count;
    show_count(axis);
  }
  next_edge_.fill(kNever);
}

void Plant::on_outputs(Cycles now, const SocOutputs& out) {
  if (ticks_) {
    if (drop_out_) drop_out_->on_pins(now, out.servo_on, out.heartbeat);
    return;
  }
  if (!drop_out_) {
    drive_pins(now, out);
    return;
  }
  SocOutputs behind = out;
  behind.servo_on = drop_out_->on_pins(now, out.servo_on, out.heartbeat);
  drive_pins(now, behind);
  find_next_event();
}

void Plant::drive_pins(Cycles now, const SocOutputs& out) {
  const auto changed =
      static_cast<std::uint8_t>((out.step ^ seen_.step) | (out.dir ^ seen_.dir) | (out.servo_on ^ seen_.servo_on));
  seen_ = out;
  for_each_bit(changed, [&](std::size_t axis) {
    ServoDrive& drive = drives_[axis];
    Shaft shaft = shafts_[axis];
    drive.on_pins(now, has_bit(out.step, axis), has_bit(out.dir, axis), has_bit(out.servo_on, axis), shaft);
    shafts_.set(axis, shaft);
    if (drive.violation() && !violation_) violation_ = drive.violation();
    if (!drive.idle()) moving_ |= bit_of(axis);
  });
  wake(now);
}

// The next step is on the grid if an axis needs it.
void Plant::wake(Cycles now) {
  if (moving_ == 0 || next_step_ != kNever) return;
  next_step_ = grid_from(now + Cycles{1});
  next_event_ = std::min(next_event_, next_step_);
}

void Plant::trip_drive(std::size_t axis, Cycles now) {
  drives_[axis].trip();
  set_bit(inputs_.drive_alarm, axis, true);
  moving_ |= bit_of(axis);
  wake(now);
}

void Plant::repair_drive(std::size_t axis) {
  drives_[axis].repair();
  set_bit(inputs_.drive_alarm, axis, drives_[axis].alarm());
}

void Plant::block(std::size_t axis) {
  ++blocks_[axis];
  mechanics_->block(axis, true);
}

void Plant::unblock(std::size_t axis) {
  if (--blocks_[axis] == 0) mechanics_->block(axis, false);
}

void Plant::weaken_brake(std::size_t axis, double share, Cycles now) {
  if (!mechanics_->weaken_brake(axis, share)) return;
  moving_ |= bit_of(axis);
  wake(now);
}

void Plant::push(std::size_t axis, double torque_nm, Cycles now) {
  if (!mechanics_->push(axis, torque_nm)) return;
  moving_ |= bit_of(axis);
  wake(now);
}

void Plant::advance(Cycles now) {
  if (now < next_event_) return;
  if (now > next_event_) {
    throw std::logic_error{
        fmt::format("plant: the event of cycle {} was missed, now {}", next_event_.value(), now.value())};
  }
  execute_edges(now);
  if (drop_out_ && drop_out_->opens_at() == now) {
    drop_out_->open();
    SocOutputs behind = seen_;
    behind.servo_on = 0;
    drive_pins(now, behind);
  }
  if (now == next_step_) step_axes(now);
  find_next_event();
}

void Plant::execute_edges(Cycles now) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (next_edge_[axis] != now) continue;
    encoders_[axis].execute_edge();
    next_edge_[axis] = encoders_[axis].next_edge();
    show_count(axis);
  }
}

// The pins that follow from the count of the encoder.
void Plant::show_count(std::size_t axis) {
  const IncrementalEncoder& encoder = encoders_[axis];
  const AxisSwitches& switches = switches_[axis];
  set_bit(inputs_.enc_a, axis, encoder.a());
  set_bit(inputs_.enc_b, axis, encoder.b());
  set_bit(inputs_.enc_z, axis, encoder.z());
  set_bit(inputs_.home, axis, switches.home(encoder.count()));
  set_bit(inputs_.limit_neg, axis, switches.limit_neg(encoder.count()));
  set_bit(inputs_.limit_pos, axis, switches.limit_pos(encoder.count()));
}

void Plant::step_axes(Cycles now) {
  step_mechanics([&](std::size_t axis, Subcounts position) {
    encoders_[axis].move(now, kPlantStep, position);
    next_edge_[axis] = encoders_[axis].next_edge();
    set_bit(inputs_.drive_alarm, axis, drives_[axis].alarm());
    set_bit(inputs_.in_position, axis, drives_[axis].in_position());
  });
  next_step_ = moving_ != 0 ? now + kPlantStep : kNever;
}

void Plant::find_next_event() {
  next_event_ = next_step_;
  if (drop_out_) next_event_ = std::min(next_event_, drop_out_->opens_at());
  for (const Cycles edge : next_edge_) next_event_ = std::min(next_event_, edge);
}

}  // namespace armature::cosim
