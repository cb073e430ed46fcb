#include "controller/language/job/instruction.hpp"

#include <array>
#include <cstddef>

#include "controller/language/job/switches.hpp"
#include "controller/language/job/words.hpp"

namespace armature::job {
namespace {

template <class... Names>
constexpr std::uint16_t tags(Names... names) noexcept {
  return static_cast<std::uint16_t>(((1U << static_cast<unsigned>(names)) | ...));
}

constexpr auto kJointTags = tags(TagName::kVj, TagName::kPl, TagName::kAcc, TagName::kDec);
constexpr auto kPathTags =
    tags(TagName::kV, TagName::kVr, TagName::kVe, TagName::kPl, TagName::kCr, TagName::kAcc, TagName::kDec);

// In the order of Op.
constexpr std::array kInstructions{
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
    Instruction{Op::kSpeed, "SPEED", "t", tags(TagName::kVj, TagName::kV, TagName::kVr),
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
    Instruction{Op::kJump, "JUMP", "lg", 0, "goes on at a label, or in another job"},
    Instruction{Op::kCall, "CALL", "jag", 0, "executes another job and returns"},
    Instruction{Op::kGetarg, "GETARG", "dv", 0, "reads an argument of CALL"},
    Instruction{Op::kRet, "RET", "?vg", 0, "returns to the calling job, with a value"},
    Instruction{Op::kPause, "PAUSE", "g", 0, "waits for the operator"},
    Instruction{Op::kAbort, "ABORT", "", 0, "ends the program"},
    Instruction{Op::kMsg, "MSG", "w", 0, "shows a text"},
    Instruction{Op::kSetualm, "SETUALM", "vq?vt", tags(TagName::kSmode), "raises an alarm of the user"},
    Instruction{Op::kIfthenexp, "IFTHENEXP", "c", 0, "executes a block if a condition holds"},
    Instruction{Op::kIfthen, "IFTHEN", "c", 0, "as IFTHENEXP"},
    Instruction{Op::kElseifexp, "ELSEIFEXP", "c", 0, "otherwise, if another condition holds"},
    Instruction{Op::kElseif, "ELSEIF", "c", 0, "as ELSEIFEXP"},
    Instruction{Op::kElse, "ELSE", "", 0, "otherwise"},
    Instruction{Op::kEndif, "ENDIF", "", 0, "ends IFTHENEXP"},
    Instruction{Op::kWhileexp, "WHILEEXP", "c", 0, "repeats a block while a condition holds"},
    Instruction{Op::kWhile, "WHILE", "c", 0, "as WHILEEXP"},
    Instruction{Op::kEndwhile, "ENDWHILE", "", 0, "ends WHILEEXP"},
    Instruction{Op::kFor, "FOR", "nh", tags(TagName::kStart, TagName::kStep), "repeats a block for each value"},
    Instruction{Op::kNext, "NEXT", "n", 0, "ends FOR"},
    Instruction{Op::kSwitch, "SWITCH", "v", 0, "selects a CASE"},
    Instruction{Op::kCase, "CASE", "v", 0, "a block for one value"},
    Instruction{Op::kDefault, "DEFAULT", "", 0, "the block for all other values"},
    Instruction{Op::kEndswitch, "ENDSWITCH", "", 0, "ends SWITCH"},
    Instruction{Op::kTimer, "TIMER", "t", tags(TagName::kT), "stands still for a time"},
    Instruction{Op::kWait, "WAIT", "?ct", tags(TagName::kT), "waits for a condition, at most for a time"},
    Instruction{Op::kCwait, "CWAIT", "", 0, "waits until the arm stands"},
    Instruction{Op::kDout, "DOUT", "os", 0, "switches outputs"},
    Instruction{Op::kDin, "DIN", "ni", 0, "reads inputs or outputs into a variable"},
    Instruction{Op::kPulse, "PULSE", "otg", tags(TagName::kT), "switches an output on for a time; does not wait"},
};
static_assert(kInstructions.size() == static_cast<std::size_t>(Op::kUnsupported));
static_assert([] {
  for (std::size_t i = 0; i < kInstructions.size(); ++i) {
    if (kInstructions[i].op != static_cast<Op>(i)) return false;
  }
  return true;
}());

// Those that load and are printed as they are. Executing one raises an alarm with its name.
constexpr std::array<std::string_view, 91> kOthers{
    "ADVINIT", "ADVSTOP", "ANTOUT",  "AOUT",    "ARATIOF", "ARATION", "ARCCTS",   "ARCCTE",  "ARCOF",   "ARCON",
    "ARCSET",  "ASC",     "AWELD",   "CAT",     "CHDSP",   "CHR$",    "CLRSENS",  "CONVSFT", "DIALOG",  "EDTLCK",
    "ENWAIT",  "FORMCUT", "GETFILE", "GETPOS",  "GETPRM",  "GETREG",  "GETTOOL",  "GUNCL",   "HAND",    "HSEN",
    "IMVREFP", "LEN",     "LINFO",   "MACRO1",  "MACRO2",  "MACRO3",  "MEMOF",    "MEMON",   "MFRAME2", "MID$",
    "MOVEXT",  "MSHIFT",  "MULMAT",  "INVMAT",  "NWAIT",   "OPEN",    "PRINT",    "PSTART",  "PWAIT",   "READ",
    "REPLAY",  "RETRY",   "SETFILE", "SETPRM",  "SETREG",  "SETTOOL", "SKILLSND", "SMOVJ",   "SMOVS",   "SPOT",
    "SREFP",   "SRCH",    "SSFTOF",  "SSFTON",  "STOPEX",  "STROKE",  "STRWAIT",  "SVSPOT",  "SYSTART", "SYEND",
    "TOOLOF",  "TOOLON",  "TSYNC",   "VAL",     "VWELD",   "WRITE",   "WVADJ",    "WVOF",    "WVON",    "MOVM",
    "EIMOVL",  "EIMOVC",  "GRIPPER", "SVGUNCL", "TRT",     "UNTIL",   "RATIO",    "QUE",     "SETPOS",  "COMARCON",
    "COMARCOF"};

constexpr auto kOtherInstructions = [] {
  std::array<Instruction, kOthers.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto op = static_cast<Op>(static_cast<std::size_t>(Op::kUnsupported) + i);
    const bool switches = switch_named(kOthers[i]).has_value();
    all[i] = {op, kOthers[i], "w", 0,
              switches ? std::string_view{"switches an output that [job] states; without it not supported"}
                       : std::string_view{"not supported: loads, and raises an alarm when it is executed"}};
  }
  return all;
}();
static_assert(kInstructions.size() + kOtherInstructions.size() < 256, "an Op is a byte");

}  // namespace

std::size_t instruction_count() noexcept {
  return kInstructions.size() + kOtherInstructions.size();
}

const Instruction& instruction_at(std::size_t index) noexcept {
  return index < kInstructions.size() ? kInstructions[index] : kOtherInstructions[index - kInstructions.size()];
}

const Instruction& instruction_of(Op op) noexcept {
  return instruction_at(static_cast<std::size_t>(op));
}

std::optional<Op> op_named(std::string_view name) noexcept {
  for (std::size_t i = static_cast<std::size_t>(Op::kComm); i < instruction_count(); ++i) {
    if (instruction_at(i).name == name) return static_cast<Op>(i);
  }
  return std::nullopt;
}

}  // namespace armature::job
