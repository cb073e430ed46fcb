// [[move]]: the commands for the controller. Each type has a header here with its keys in the user's units and the
// command that the controller gets; CommandKind is the list of all. The loader, KEYS.md, the schema and the log follow.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "cosim/scenario/moves/jog.hpp"
#include "cosim/scenario/moves/joint.hpp"
#include "cosim/scenario/moves/path_shapes.hpp"
#include "cosim/scenario/moves/pins.hpp"
#include "cosim/scenario/moves/plain.hpp"
#include "cosim/scenario/moves/polyline.hpp"
#include "cosim/scenario/pin_spec.hpp"

namespace armature::cosim {

// The members of a struct are the keys of its kind.
using CommandKind =
    std::variant<JointSpec, LineSpec, ArcSpec, CircleSpec, ArcAboutSpec, SplineSpec, PolylineSpec, DwellSpec, HoldSpec,
                 ResumeSpec, OverrideSpec, StopSpec, ClearFaultSpec, DoutSpec, WaitDinSpec, JogSpec, HomeSpec>;

struct CommandSpec {
  double at_s = 0;
  CommandKind kind{};
  std::vector<PathOutputSpec> outputs{};  // of a path or a joint move
  int line = 0;                           // in the scenario file, for messages
  std::uint32_t index = 0;                // in the scenario file, as in `move[3]`; the tag of the command
};

// The path of the tool; null: the command has none.
[[nodiscard]] constexpr const PathSpec* path_of(const CommandKind& kind) {
  return std::visit(
      [](const auto& move) -> const PathSpec* {
        if constexpr (requires { move.path; }) {
          return &move.path;
        } else {
          return nullptr;
        }
      },
      kind);
}

// The pose that the command moves the tool to; null: none, or joint angles.
[[nodiscard]] constexpr const PoseTarget* pose_of(const CommandKind& kind) {
  if (const PathSpec* path = path_of(kind)) return &path->pose;
  const auto* joint = std::get_if<JointSpec>(&kind);
  return joint != nullptr && !joint->target_deg ? &joint->pose : nullptr;
}

}  // namespace armature::cosim
