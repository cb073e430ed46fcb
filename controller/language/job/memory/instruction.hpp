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

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/job/memory/words.hpp"

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

// True for a table with one row for each supported operation, in the order of Op.
template <class Rows>
[[nodiscard]] constexpr bool has_each_op(const Rows& rows) noexcept {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].op != static_cast<Op>(i)) return false;
  }
  return rows.size() == static_cast<std::size_t>(Op::kUnsupported);
}

// A mask of TagName.
template <class... Names>
[[nodiscard]] constexpr std::uint16_t tag_mask(Names... names) noexcept {
  return static_cast<std::uint16_t>(((1U << static_cast<unsigned>(names)) | ...));
}

inline constexpr auto kJointTags = tag_mask(TagName::kVj, TagName::kPl, TagName::kAcc, TagName::kDec);
inline constexpr auto kPathTags =
    tag_mask(TagName::kV, TagName::kVr, TagName::kVe, TagName::kPl, TagName::kCr, TagName::kAcc, TagName::kDec);

// Those that are supported, in the order of Op.
inline constexpr std::array kInstructions{
    Instruction{Op::kBlank, "", "", 0, "an empty line"},
    Instruction{Op::kComment, "'", "w", 0, "a comment"},
    Instruction{Op::kLabel, "*", "", 0, "the target of JUMP"},
    Instruction{Op::kComm, "COMM", "w", 0, "an instruction that is switched off"},
    Instruction{Op::kNop, "NOP", "", 0, "does nothing; the first instruction of a job"},
    Instruction{Op::kEnd, "END", "", 0, "ends the job, or returns to the calling one"},
    Instruction{Op::kMovj, "MOVJ", "mt?y", kJointTags, "moves all joints; UNTIL IN#(n)=ON ends it early"},
    Instruction{Op::kMovl, "MOVL", "mt?y", kPathTags, "moves the tool on a line; UNTIL as in MOVJ"},
    Instruction{Op::kMovc, "MOVC", "mt", kPathTags, "moves the tool on arcs through three or more points"},
    Instruction{Op::kMovs, "MOVS", "mt", kPathTags, "moves the tool on a smooth curve through points"},
    Instruction{Op::kSmovl, "SMOVL", "mt?y", kPathTags, "as MOVL"},
    Instruction{Op::kSmovc, "SMOVC", "mt", kPathTags, "as MOVC"},
    Instruction{Op::kImov, "IMOV", "pt?f", static_cast<std::uint16_t>(kPathTags | kJointTags),
                "moves by a position variable, in a frame"},
    Instruction{Op::kRefp, "REFP", "vm", 0, "a reference point; no motion"},
    Instruction{Op::kSpeed, "SPEED", "t", tag_mask(TagName::kVj, TagName::kV, TagName::kVr),
                "the speeds of moves without one"},
    Instruction{Op::kSfton, "SFTON", "p?f", 0, "shifts the positions of the moves that follow"},
    Instruction{Op::kSftof, "SFTOF", "", 0, "ends the shift"},
    Instruction{Op::kMframe, "MFRAME", "uppp", 0, "a user frame from origin, point on x and point in xy"},
    Instruction{Op::kCnvrt, "CNVRT", "ppf?k", 0, "converts a position into a frame"},
    Instruction{Op::kGets, "GETS", "dv", 0, "reads a system variable: $PX000, $PX001, $RV"},
    Instruction{Op::kSete, "SETE", "pxv", 0, "sets an element of a position; 0 sets all"},
    Instruction{Op::kGete, "GETE", "npx", 0, "reads an element of a position"},
    Instruction{Op::kSet, "SET", "de", 0, "sets a variable"},
    Instruction{Op::kAdd, "ADD", "dv", 0, "adds to a variable"},
    Instruction{Op::kSub, "SUB", "dv", 0, "subtracts from a variable"},
    Instruction{Op::kMul, "MUL", "dv", 0, "multiplies a variable"},
    Instruction{Op::kDiv, "DIV", "dv", 0, "divides a variable"},
    Instruction{Op::kInc, "INC", "n", 0, "adds 1"},
    Instruction{Op::kDec, "DEC", "n", 0, "subtracts 1"},
    Instruction{Op::kAnd, "AND", "nv", 0, "bits of both"},
    Instruction{Op::kOr, "OR", "nv", 0, "bits of either"},
    Instruction{Op::kXor, "XOR", "nv", 0, "bits of one of both"},
    Instruction{Op::kNot, "NOT", "nv", 0, "bits inverted"},
    Instruction{Op::kSqrt, "SQRT", "nv", 0, "square root"},
    Instruction{Op::kSin, "SIN", "nv", 0, "sine of degrees"},
    Instruction{Op::kCos, "COS", "nv", 0, "cosine of degrees"},
    Instruction{Op::kAtan, "ATAN", "nv", 0, "arc tangent in degrees"},
    Instruction{Op::kClear, "CLEAR", "d?v", 0, "sets variables to 0 from one on: a number of them, or ALL"},
    Instruction{Op::kJump, "JUMP", "lg", 0, "continues at a label, or in another job"},
    Instruction{Op::kCall, "CALL", "jag", 0, "executes another job and returns"},
    Instruction{Op::kGetarg, "GETARG", "dv", 0, "reads an argument of CALL"},
    Instruction{Op::kRet, "RET", "?vg", 0, "returns to the calling job, with a value"},
    Instruction{Op::kPause, "PAUSE", "g", 0, "waits for the operator"},
    Instruction{Op::kAbort, "ABORT", "", 0, "ends the program"},
    Instruction{Op::kMsg, "MSG", "w", 0, "shows a text"},
    Instruction{Op::kSetualm, "SETUALM", "vq?vt", tag_mask(TagName::kSmode), "raises an alarm of the user"},
    Instruction{Op::kIfthenexp, "IFTHENEXP", "c", 0, "executes a block if a condition holds"},
    Instruction{Op::kIfthen, "IFTHEN", "c", 0, "as IFTHENEXP"},
    Instruction{Op::kElseifexp, "ELSEIFEXP", "c", 0, "otherwise, if another condition holds"},
    Instruction{Op::kElseif, "ELSEIF", "c", 0, "as ELSEIFEXP"},
    Instruction{Op::kElse, "ELSE", "", 0, "otherwise"},
    Instruction{Op::kEndif, "ENDIF", "", 0, "ends IFTHENEXP"},
    Instruction{Op::kWhileexp, "WHILEEXP", "c", 0, "repeats a block while a condition holds"},
    Instruction{Op::kWhile, "WHILE", "c", 0, "as WHILEEXP"},
    Instruction{Op::kEndwhile, "ENDWHILE", "", 0, "ends WHILEEXP"},
    Instruction{Op::kFor, "FOR", "nh", tag_mask(TagName::kStart, TagName::kStep), "repeats a block for each value"},
    Instruction{Op::kNext, "NEXT", "n", 0, "ends FOR"},
    Instruction{Op::kSwitch, "SWITCH", "v", 0, "selects a CASE"},
    Instruction{Op::kCase, "CASE", "v", 0, "a block for one value"},
    Instruction{Op::kDefault, "DEFAULT", "", 0, "the block for all other values"},
    Instruction{Op::kEndswitch, "ENDSWITCH", "", 0, "ends SWITCH"},
    Instruction{Op::kTimer, "TIMER", "t", tag_mask(TagName::kT), "stands still for a time"},
    Instruction{Op::kWait, "WAIT", "?ct", tag_mask(TagName::kT), "waits for a condition, at most for a time"},
    Instruction{Op::kCwait, "CWAIT", "", 0, "waits until the arm stands"},
    Instruction{Op::kDout, "DOUT", "os", 0, "switches outputs"},
    Instruction{Op::kDin, "DIN", "ni", 0, "reads inputs or outputs into a variable"},
    Instruction{Op::kPulse, "PULSE", "otg", tag_mask(TagName::kT), "switches an output on for a time; does not wait"},
};
static_assert(has_each_op(kInstructions));

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
