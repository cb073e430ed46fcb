// The words of the language besides its instructions: variables, pins and frames, keywords, tags.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace armature::job {

enum class VariableType : std::uint8_t { kB, kI, kD, kR, kS, kP, kBp, kEx, kReturn, kCount };
enum class PositionLetter : std::uint8_t { kC, kBc, kEc, kP, kBp, kEx, kCount };
enum class IoType : std::uint8_t {
  kInput,
  kOutput,
  kInputGroup,
  kOutputGroup,
  kInputHalfGroup,
  kOutputHalfGroup,
  kUserFrame,
  kTool,
  kArgument,
  kSpecificInput,
  kSpecificOutput,
  kRegister,
  kAnalog,
  kRobotInput,
  kCount,
};
enum class Word : std::uint8_t {
  kOn,
  kOff,
  kIf,
  kIfExpress,
  kAndExp,
  kOrExp,
  kAndIf,
  kOrIf,
  kFpt,
  kTo,
  kExpress,
  kForExpress,
  kBaseFrame,
  kRobotFrame,
  kToolFrame,
  kMasterTool,
  kAll,
  kArgument,
  kLabelOf,
  kEqual,
  kNotEqual,
  kLessEqual,
  kGreaterEqual,
  kLess,
  kGreater,
  kPlus,
  kMinus,
  kTimes,
  kDivide,
  kOpen,
  kClose,
  kUntil,
  kCount,
};
enum class TagName : std::uint8_t { kVj, kV, kVr, kVe, kPl, kCr, kAcc, kDec, kT, kStart, kStep, kSmode, kCount };

template <class Enum>
inline constexpr std::size_t kCountOf = static_cast<std::size_t>(Enum::kCount);

inline constexpr std::array<std::string_view, kCountOf<VariableType>> kVariableNames{"B", "I",  "D",  "R", "S",
                                                                                     "P", "BP", "EX", "RV"};
inline constexpr std::array<std::string_view, kCountOf<PositionLetter>> kPositionNames{"C", "BC", "EC",
                                                                                       "P", "BP", "EX"};
inline constexpr std::array<std::string_view, kCountOf<IoType>> kIoNames{
    "IN", "OT", "IG", "OG", "IGH", "OGH", "UF", "TL", "IARG", "SIN", "SOUT", "MREG", "AO", "RIN"};
inline constexpr std::array<std::string_view, kCountOf<Word>> kWordNames{
    "ON",         "OFF", "IF", "IFEXPRESS", "ANDEXP", "OREXP", "ANDIF", "ORIF",   "FPT", "TO",   "EXPRESS",
    "FOREXPRESS", "BF",  "RF", "TF",        "MTF",    "ALL",   "ARGF",  "LABEL:", "=",   "<>",   "<=",
    ">=",         "<",   ">",  "+",         "-",      "*",     "/",     "(",      ")",   "UNTIL"};
inline constexpr std::array<std::string_view, kCountOf<TagName>> kTagNames{
    "VJ", "V", "VR", "VE", "PL", "CR", "ACC", "DEC", "T", "START", "STEP", "SMODE"};

// The element with this name.
template <class Enum>
[[nodiscard]] constexpr std::optional<Enum> named(const std::array<std::string_view, kCountOf<Enum>>& names,
                                                  std::string_view name) noexcept {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<Enum>(i);
  }
  return std::nullopt;
}
template <class Enum>
[[nodiscard]] constexpr std::string_view name_of(const std::array<std::string_view, kCountOf<Enum>>& names,
                                                 std::uint8_t what) noexcept {
  return what < names.size() ? names[what] : "?";
}

[[nodiscard]] constexpr bool is_comparison(Word word) noexcept {
  return word >= Word::kEqual && word <= Word::kGreater;
}
[[nodiscard]] constexpr bool is_calculation(Word word) noexcept {
  return word >= Word::kPlus && word <= Word::kDivide;
}

}  // namespace armature::job
