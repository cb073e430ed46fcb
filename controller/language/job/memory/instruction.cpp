#include "controller/language/job/memory/instruction.hpp"

#include "controller/language/job/memory/switches.hpp"

namespace armature::job {
namespace {

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
