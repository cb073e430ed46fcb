// A finished plan of any kind, which core 1 sends to core 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "controller/base/units.hpp"
#include "controller/trajectory/plan/cartesian_plan.hpp"
#include "controller/trajectory/plan/joint_chain.hpp"
#include "controller/trajectory/plan/joint_move.hpp"

namespace armature {

// One joint move, a chain of joint moves, a path of the tool, or a joined plan: up to kMaxParts paths and joint chains
// in turn, each of which begins in the state of motion in which the one before ends.
//
// Contains one of all kinds, with room for all. So an assignment of a plan of another kind only copies that plan. A
// variant would first initialise the 490 KB of an empty path. A joined plan uses the room of the path and that of the
// joint chain for its first two parts. Its third part is the plan in the next entry of the queue, to which it refers.
class MotionPlan {
 public:
  static constexpr std::size_t kMaxParts = 3;
  // Moves of a joined plan.
  static constexpr std::size_t kMaxMoves = CartesianPlan::kMaxFirstSegments;

  // A path or a chain in a joined plan. It is executed from `from` to `until` of its own time.
  struct Part {
    const CartesianPlan* path = nullptr;  // exactly one of both
    const JointChain* chain = nullptr;
    Ticks start{};  // from the start of the joined plan
    Ticks from{}, until{};
    bool in_motion = false;  // at its start

    [[nodiscard]] Ticks end() const noexcept { return start + (until - from); }
    [[nodiscard]] std::size_t moves() const noexcept { return path != nullptr ? path->count : chain->count; }
  };

  MotionPlan() = default;  // empty, takes no time
  // NOLINTBEGIN(google-explicit-constructor, hicpp-explicit-conversions): implicit on purpose
  MotionPlan(const JointPlan& plan) noexcept : joint_{plan} {}
  MotionPlan(const JointChain& plan) noexcept : kind_{Kind::kJointChain}, chain_{plan} {}
  MotionPlan(const CartesianPlan& plan) noexcept : kind_{Kind::kPath}, path_{plan} {}
  // NOLINTEND(google-explicit-constructor, hicpp-explicit-conversions)
  MotionPlan(const MotionPlan& other) noexcept { *this = other; }
  MotionPlan& operator=(const MotionPlan& other) noexcept;
  // Without an empty plan of every other kind in between, which needs room on the stack.
  MotionPlan& operator=(const JointPlan& plan) noexcept {
    kind_ = Kind::kJoint;
    joint_ = plan;
    return *this;
  }
  MotionPlan& operator=(const JointChain& plan) noexcept {
    kind_ = Kind::kJointChain;
    chain_ = plan;
    return *this;
  }
  // A chain of one move.
  MotionPlan& operator=(const RetargetPlan& plan) noexcept {
    kind_ = Kind::kJointChain;
    chain_ = plan;
    return *this;
  }
  MotionPlan& operator=(const CartesianPlan& plan) noexcept {
    kind_ = Kind::kPath;
    path_ = plan;
    return *this;
  }

  // The plan if it is of that kind, otherwise null.
  [[nodiscard]] const JointPlan* joint() const noexcept { return kind_ == Kind::kJoint ? &joint_ : nullptr; }
  [[nodiscard]] const JointChain* joint_chain() const noexcept {
    return kind_ == Kind::kJointChain ? &chain_ : nullptr;
  }
  [[nodiscard]] const CartesianPlan* path() const noexcept { return kind_ == Kind::kPath ? &path_ : nullptr; }
  [[nodiscard]] bool is_joined() const noexcept { return kind_ == Kind::kJoined; }

  // Number of entries of the queue that the plan takes: 2 if it refers to the next one.
  [[nodiscard]] std::size_t entries() const noexcept { return is_joined() && next_ != nullptr ? 2 : 1; }

  // Joined plans. begin_joined() makes this one without parts; part() is valid until the plan is changed or copied.
  void begin_joined() noexcept;
  [[nodiscard]] std::size_t parts() const noexcept { return part_count_; }
  [[nodiscard]] Part part(std::size_t index) const noexcept;
  // The last part that has begun at this time, ticks.
  [[nodiscard]] Part part_at(double ticks) const noexcept;
  // Adds one of the first two parts, a path and a joint chain in any order. It is executed from `from` on; `in_motion`:
  // it begins so.
  void add(const JointChain& chain, Ticks from, bool in_motion) noexcept;
  void add(const CartesianPlan& path, Ticks from, bool in_motion) noexcept;
  // Adds the third part, a path or a joint chain, whichever the second one is not. It is not copied, so it must stay
  // as long as this plan and its copies.
  void add_next_of_queue(const MotionPlan& plan, Ticks from, bool in_motion) noexcept;
  // The last part ends at `until` of its own time.
  void cut_last(Ticks until) noexcept { parts_[part_count_ - 1].until = until; }
  // A joined plan of one part, which is a whole path, becomes that path.
  void become_path() noexcept { kind_ = Kind::kPath; }

 private:
  enum class Kind : std::uint8_t { kJoint, kJointChain, kPath, kJoined };

  struct StoredPart {
    bool is_path = false;
    bool in_motion = false;
    Ticks start{}, from{}, until{};
  };
  void add(const StoredPart& part) noexcept;

  Kind kind_ = Kind::kJoint;
  JointPlan joint_{};
  CartesianPlan path_{};
  JointChain chain_{};
  const MotionPlan* next_ = nullptr;  // the third part
  std::array<StoredPart, kMaxParts> parts_{};
  std::size_t part_count_ = 0;
};

[[nodiscard]] Ticks duration(const MotionPlan& plan) noexcept;

// Where the plan ends.
[[nodiscard]] const PerAxis<Radians>& target_of(const MotionPlan& plan) noexcept;

// When its outputs are switched; the moves of a joined plan have none.
[[nodiscard]] std::span<const TimedOutput> outputs_of(const MotionPlan& plan) noexcept;

[[nodiscard]] inline bool is_dwell(const MotionPlan& plan) noexcept {
  return plan.joint() != nullptr && plan.joint()->is_dwell;
}

// Number of moves in the plan: the segments of paths and the moves of joint chains, otherwise one.
[[nodiscard]] std::size_t moves_in(const MotionPlan& plan) noexcept;

// A part of a joined plan, and one of its moves.
struct PartMove {
  MotionPlan::Part part{};
  std::size_t move = 0;  // of the part
};
[[nodiscard]] PartMove part_move(const MotionPlan& plan, std::size_t move) noexcept;

// Begin and end of a move, from the start of the plan.
struct MoveSpan {
  Ticks start{};
  Ticks end{};
};
[[nodiscard]] MoveSpan span_of(const MotionPlan& plan, std::size_t move) noexcept;

}  // namespace armature
