// The tables of a scenario file and of a robot file: one entry for each key, in files by subject.
#pragma once

#include <string>

#include "cosim/scenario/keys/key_table.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

[[nodiscard]] const KeyTable<Scenario>& scenario_keys();  // the whole file
[[nodiscard]] const KeyTable<ControllerSpec>& controller_keys();
[[nodiscard]] const KeyTable<SolverSpec>& solver_keys();
[[nodiscard]] const KeyTable<CpuSpec>& cpu_keys();
[[nodiscard]] const KeyTable<BusSpec>& bus_keys();
[[nodiscard]] const KeyTable<PaperSpec>& paper_keys();
[[nodiscard]] const KeyTable<TraceSpec>& trace_keys();
[[nodiscard]] const KeyTable<GoldenSpec>& golden_keys();
[[nodiscard]] const KeyTable<PoseSpec>& tool_keys();
[[nodiscard]] const KeyTable<FrameSpec>& frame_keys();
[[nodiscard]] const KeyTable<ConveyorSpec>& conveyor_keys();
[[nodiscard]] const KeyTable<CommandSpec>& move_keys();
[[nodiscard]] const KeyTable<StreamSpec>& stream_keys();
[[nodiscard]] const KeyTable<FaultSpec>& fault_keys();
[[nodiscard]] const KeyTable<InputSpec>& input_keys();
[[nodiscard]] const KeyTable<SerialSpec>& serial_keys();
[[nodiscard]] const KeyTable<SerialSendSpec>& serial_send_keys();
[[nodiscard]] const KeyTable<PendantSpec>& pendant_keys();
[[nodiscard]] const KeyTable<PendantStepSpec>& pendant_step_keys();
[[nodiscard]] const KeyTable<GcodeSpec>& gcode_keys();
[[nodiscard]] const KeyTable<GcodeAnalogSpec>& gcode_analog_keys();
[[nodiscard]] const KeyTable<JobSpec>& job_keys();
[[nodiscard]] const KeyTable<JobToolSpec>& job_tool_keys();
[[nodiscard]] const KeyTable<ExpectSpec>& expect_keys();
[[nodiscard]] const KeyTable<OutputChangeSpec>& expected_output_keys();
[[nodiscard]] const KeyTable<PathOutputSpec>& path_output_keys();

[[nodiscard]] const KeyTable<RobotSpec>& robot_keys();  // the whole file; robot_loader reads its tables
[[nodiscard]] const KeyTable<KinematicsSpec>& kinematics_keys();
[[nodiscard]] const KeyTable<AxisSpec>& axis_keys();
[[nodiscard]] const KeyTable<DynamicsSpec>& dynamics_keys();
[[nodiscard]] const KeyTable<BodySpec>& body_keys();
[[nodiscard]] const KeyTable<MeshesSpec>& meshes_keys();

// Both kinds of files, for documents and schemas.
[[nodiscard]] TableInfo scenario_file();
[[nodiscard]] TableInfo robot_file();

}  // namespace armature::cosim
