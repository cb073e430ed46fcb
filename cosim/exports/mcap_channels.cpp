#include "cosim/exports/mcap_channels.hpp"

#include <initializer_list>
#include <string>
#include <utility>

#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

using Members = std::initializer_list<std::pair<const char*, Json>>;

Json object(Members members) {
  Json properties = Json::object();
  for (const auto& [name, schema] : members) properties[name] = schema;
  return {{"type", "object"}, {"properties", std::move(properties)}};
}

Json type(const char* name) {
  return {{"type", name}};
}

Json array_of(const Json& items) {
  return {{"type", "array"}, {"items", items}};
}

// Seconds and nanoseconds of simulated time.
Json time_schema() {
  return object({{"sec", type("integer")}, {"nsec", type("integer")}});
}

Json vector_schema() {
  return object({{"x", type("number")}, {"y", type("number")}, {"z", type("number")}});
}

Json rotation_schema() {
  return object({{"x", type("number")}, {"y", type("number")}, {"z", type("number")}, {"w", type("number")}});
}

Json joints_schema() {
  const Json joint = object({{"name", type("string")}, {"position", type("number")}, {"velocity", type("number")}});
  return object({{"timestamp", time_schema()}, {"joints", array_of(joint)}});
}

Json pose_schema() {
  return object({{"timestamp", time_schema()},
                 {"frame_id", type("string")},
                 {"pose", object({{"position", vector_schema()}, {"orientation", rotation_schema()}})}});
}

Json transforms_schema() {
  const Json one = object({{"timestamp", time_schema()},
                           {"parent_frame_id", type("string")},
                           {"child_frame_id", type("string")},
                           {"translation", vector_schema()},
                           {"rotation", rotation_schema()}});
  return object({{"transforms", array_of(one)}});
}

Json log_schema() {
  return object({{"timestamp", time_schema()},
                 {"level", type("integer")},
                 {"message", type("string")},
                 {"name", type("string")},
                 {"file", type("string")},
                 {"line", type("integer")}});
}

Json line_schema() {
  return object(
      {{"timestamp", time_schema()}, {"file", type("string")}, {"line", type("integer")}, {"text", type("string")}});
}

Json load_schema() {
  return object({{"timestamp", time_schema()},
                 {"awake_cycles", array_of(type("integer"))},
                 {"bus_cycles", array_of(type("integer"))}});
}

Json state_schema() {
  return object({{"timestamp", time_schema()}, {"state", type("string")}});
}

McapChannel channel(const char* topic, const char* name, Json schema) {
  schema["title"] = name;
  return {.topic = topic, .schema_name = name, .schema = schema.dump()};
}

}  // namespace

std::vector<McapChannel> run_channels() {
  return {channel("/joint_states", "foxglove.JointStates", joints_schema()),
          channel("/joint_set_points", "foxglove.JointStates", joints_schema()),
          channel("/tool_pose", "foxglove.PoseInFrame", pose_schema()),
          channel("/tool_set_point", "foxglove.PoseInFrame", pose_schema()),
          channel("/tf", "foxglove.FrameTransforms", transforms_schema()),
          channel("/state", "armature.State", state_schema()),
          channel("/events", "foxglove.Log", log_schema()),
          channel("/program/arm", "armature.ProgramLine", line_schema()),
          channel("/program/core1", "armature.ProgramLine", line_schema()),
          channel("/cores", "armature.CoreLoad", load_schema())};
}

}  // namespace armature::cosim
