// The kinds of fault of drives and mechanics.
#pragma once

#include <fmt/format.h>

#include <string>

#include "cosim/fault/fault_spec.hpp"
#include "cosim/scenario/tables/fault_entry.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {

template <>
[[nodiscard]] inline const FaultEntry<ExtraPulses>& fault_entry<ExtraPulses>() {
  static const FaultEntry<ExtraPulses> kEntry{
      .name = "extra_pulses",
      .text = "a drive counts some pulses twice",
      .keys = {axis_key<ExtraPulses>(), key("count", &ExtraPulses::count, between(1, kMaxCount, "pulses"),
                                            "The drive counts the next pulses twice, this many.")
                                            .required()},
      .details =
          [](const ExtraPulses& fault) { return fmt::format(" of axis {}, {} pulses", fault.axis, fault.count); },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<DriveAlarm>& fault_entry<DriveAlarm>() {
  static const FaultEntry<DriveAlarm> kEntry{
      .name = "drive_alarm",
      .text = "a drive has an internal fault. Its alarm stays until the fault is over and its servo was off",
      .keys = {axis_key<DriveAlarm>(), duration_key<DriveAlarm>()},
      .details = axis_and_duration<DriveAlarm>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<AxisBlocked>& fault_entry<AxisBlocked>() {
  static const FaultEntry<AxisBlocked> kEntry{
      .name = "axis_blocked",
      .text = "a motor shaft cannot turn: the arm has hit something",
      .keys = {axis_key<AxisBlocked>(), duration_key<AxisBlocked>()},
      .details = axis_and_duration<AxisBlocked>,
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<BrakeSlip>& fault_entry<BrakeSlip>() {
  static const FaultEntry<BrakeSlip> kEntry{
      .name = "brake_slip",
      .text = "the holding brake of an axis has lost torque. Only axes with `plant = \"dynamic\"` have one",
      .keys = {axis_key<BrakeSlip>(),
               key("share", &BrakeSlip::share, between(0, 1), "The part of its torque that is left.").required(),
               duration_key<BrakeSlip>()},
      .details =
          [](const BrakeSlip& fault) {
            return fmt::format(" of axis {}, {} of its torque left", fault.axis, number_text(fault.share)) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

template <>
[[nodiscard]] inline const FaultEntry<CollisionTorque>& fault_entry<CollisionTorque>() {
  static const FaultEntry<CollisionTorque> kEntry{
      .name = "collision_torque",
      .text =
          "something pushes against a joint, behind its gear. Only joints with `plant = \"dynamic\"` are behind a gear",
      .keys = {axis_key<CollisionTorque>(),
               key("torque_nm", &CollisionTorque::torque_nm, between(-kMaxTorqueNm, kMaxTorqueNm, "N m"),
                   "The torque on the joint, in its positive direction.")
                   .required()
                   .checked([](CollisionTorque& fault, const KeyContext&) {
                     return fault.torque_nm != 0 ? std::string{} : "expected a torque that is not 0";
                   }),
               duration_key<CollisionTorque>()},
      .details =
          [](const CollisionTorque& fault) {
            return fmt::format(" of axis {}, {} N m", fault.axis, number_text(fault.torque_nm)) +
                   duration_details(fault);
          },
  };
  return kEntry;
}

}  // namespace armature::cosim
