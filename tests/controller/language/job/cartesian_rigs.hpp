// Jobs with positions in the base in front of the arm, and rigs that execute them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "tests/controller/language/job/machine_rig.hpp"

namespace armature::test {

// Positions in the base, with the tool down, in front of the arm; NOP is line 22. P1 is 10 mm along y.
inline std::string cartesian_job_of(const std::string& instructions) {
  return "/JOB\n//NAME TEST\n//POS\n///NPOS 6,0,0,4,0,0\n///TOOL 0\n///POSTYPE BASE\n///RECTAN\n///RCONF 0,0,0,0,0,0\n"
         "C00000=300,0,300,180,0,180\nC00001=350,50,300,180,0,180\nC00002=400,0,300,180,0,180\nC00003=350,-50,300,180,"
         "0,180\n"
         "C00004=300,0,300,180,0,180\n///RCONF 1,0,0,0,0,0\nC00005=300,0,300,180,0,180\n///RCONF "
         "0,0,0,0,0,0\nP001=0,10,0,0,0,0\n"
         "P002=0,0,0,0,0,90\nP004=400,0,300,180,0,180\n///POSTYPE PULSE\n///PULSE\nP003=1000,0,0,0,0,0\n//INST\nNOP\n" +
         instructions + "END\n";
}

inline const CartesianMove& path(const MachineRig& rig, std::size_t i) {
  return rig.port.sent_as<CartesianMove>(i);
}

// A rig whose arm stands at a place from which these positions are near.
inline MachineRig moved(const std::string& instructions) {
  MachineRig rig{cartesian_job_of(instructions)};
  rig.port.at = degrees({0, 10, 20, 0, 60, 0});
  EXPECT_EQ(rig.run(), Program::Progress::kEnded) << (rig.port.alarms.empty() ? "" : rig.port.alarms.front());
  return rig;
}

// Positions in the base with the tool down. C6 is at the wrist singularity of the rig's arm. At C7 axis 6 is beyond
// half a turn. P001 is 10 mm along y, P003 has pulses.
inline std::string job_with_postures(const std::string& instructions) {
  return "/JOB\n//NAME TEST\n//POS\n///NPOS 8,0,0,2,0,0\n///TOOL 0\n///POSTYPE BASE\n///RECTAN\n"
         "///RCONF 0,0,0,0,0,0\nC0=300,0,300,180,0,180\nC1=350,50,300,180,0,180\nC2=400,0,300,180,0,180\n"
         "C3=350,-50,300,180,0,180\nC4=300,0,300,180,0,180\n///RCONF 1,0,0,0,0,0\nC5=300,0,300,180,0,180\n"
         "///RCONF 0,0,0,0,0,0\nC6=474,0,630,0,90,0\n"
         "///RCONF 0,0,0,0,1,0\nC7=350,0,300,180,0,180\n///RCONF 0,0,0,0,0,0\nP001=0,10,0,0,0,0\n///POSTYPE "
         "PULSE\n///PULSE\n"
         "P003=1000,0,0,0,0,0\n//INST\nNOP\n" +
         instructions + "END\n";
}

// The arm stands when the program starts, and moves from the first command on.
struct MovingRig : MachineRig {
  explicit MovingRig(const std::string& instructions, const RobotModel& model = irb120())
      : MachineRig{{job_with_postures(instructions)}, model} {
    port.at = degrees({0, 10, 20, 0, 60, 0});
  }

  Progress run_ahead() {
    while (port.sent.empty()) {
      const Progress progress = machine->step(port);
      if (progress != Progress::kWorking) return progress;
    }
    port.arrived = false;
    return run();
  }
  // True when the program waits for the arm with so many commands sent, and continues when the arm stands.
  bool waits_behind(std::size_t commands) {
    if (run_ahead() != Progress::kWaiting || port.sent.size() != commands) return false;
    const std::int64_t inverses = port.inverses;
    if (run() != Progress::kWaiting || port.inverses != inverses) return false;  // and computes nothing meanwhile
    port.arrived = true;
    return run() == Progress::kEnded;
  }
};

}  // namespace armature::test
