// The table of all instructions. The loader, the printer, the listing, the machine and the documentation read it.
//
// A pattern says which operands an instruction has:
//   m  target of a move: C000, P000, LP000, P[B000]      p  position variable      d  any variable, to be written
//   n  numeric variable                                   v  value: constant, variable or state of a pin
//   e  value, or EXPRESS with a calculation               x  element of a position: (n)
//   i  input or output that is read                       o  output                 s  ON, OFF or a value
//   c  condition                                          g  IF condition, or nothing
//   l  *LABEL, LABEL: variable, or JOB:NAME               j  JOB:NAME               a  arguments: ARGF value
//   f  frame: BF, RF, TF or UF#(n)                        u  UF#(n)                 k  TL#(n)
//   q  text in quotes                                     t  tags of the instruction, in any order
//   h  = START value TO value STEP value of FOR           w  the rest of the line
//   y  UNTIL and an input
// `?` before a letter: the operand may be missing. All letters from there on may then be missing.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace armature::job {

enum class Op : std::uint8_t {
  kBlank,    // an empty line
  kComment,  // 'text
  kLabel,    // *NAME
  kComm,     // COMM and an instruction that is switched off
  kNop,
  kEnd,
  kMovj,
  kMovl,
  kMovc,
  kMovs,
  kSmovl,
  kSmovc,
  kImov,
  kRefp,
  kSpeed,
  kSfton,
  kSftof,
  kMframe,
  kCnvrt,
  kGets,
  kSete,
  kGete,
  kSet,
  kAdd,
  kSub,
  kMul,
  kDiv,
  kInc,
  kDec,
  kAnd,
  kOr,
  kXor,
  kNot,
  kSqrt,
  kSin,
  kCos,
  kAtan,
  kClear,
  kJump,
  kCall,
  kGetarg,
  kRet,
  kPause,
  kAbort,
  kMsg,
  kSetualm,
  kIfthenexp,
  kIfthen,
  kElseifexp,
  kElseif,
  kElse,
  kEndif,
  kWhileexp,
  kWhile,
  kEndwhile,
  kFor,
  kNext,
  kSwitch,
  kCase,
  kDefault,
  kEndswitch,
  kTimer,
  kWait,
  kCwait,
  kDout,
  kDin,
  kPulse,
  kUnsupported,  // the first of those that load but raise an alarm
};

struct Instruction {
  Op op = Op::kBlank;
  std::string_view name{};
  std::string_view pattern{};
  std::uint16_t tags = 0;   // mask of TagName
  std::string_view text{};  // what it does, for the documentation
};

// Of an operation, and of a name in a program; nothing if no instruction has this name. Operations from kUnsupported on
// have one entry each: Op is then kUnsupported plus its place among these.
[[nodiscard]] const Instruction& instruction_of(Op op) noexcept;
[[nodiscard]] std::optional<Op> op_named(std::string_view name) noexcept;
// The number of entries of the table.
[[nodiscard]] std::size_t instruction_count() noexcept;
[[nodiscard]] const Instruction& instruction_at(std::size_t index) noexcept;

[[nodiscard]] constexpr bool is_supported(Op op) noexcept {
  return op < Op::kUnsupported;
}
// Moves that belong to a run of points.
[[nodiscard]] constexpr bool is_arc(Op op) noexcept {
  return op == Op::kMovc || op == Op::kSmovc;
}
// Moves that an input may end early.
[[nodiscard]] constexpr bool may_end_early(Op op) noexcept {
  return op == Op::kMovj || op == Op::kMovl || op == Op::kSmovl;
}
[[nodiscard]] constexpr bool is_move(Op op) noexcept {
  return op >= Op::kMovj && op <= Op::kImov;
}

}  // namespace armature::job
