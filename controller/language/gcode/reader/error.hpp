// What can be wrong with a G-code program, with the place and the code that it concerns.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/language/text/fixed_text.hpp"

namespace armature::gcode {

enum class ErrorCode : std::uint8_t {
  // The text of a line.
  kLineTooLong,
  kBadCharacter,
  kCommentNotClosed,
  kNestedComment,
  kNumberExpected,
  kNumberTooLong,
  kValueExpected,
  kBracketExpected,
  kBracketNotClosed,
  kTooDeep,
  kUnknownFunction,
  kOperatorExpected,
  kSlashExpected,
  kNameNotClosed,
  kNameTooLong,
  kEqualSignExpected,
  kNotAnInteger,
  kTooManyAssignments,
  // Values.
  kDivisionByZero,
  kOutsideDomain,
  kValueTooLarge,
  kParameterNumber,
  kParameterUndefined,
  kParameterReadOnly,
  kTooManyNames,
  // Words of a line.
  kUnknownCode,
  kUnsupportedCode,
  kCodeNotFirst,
  kUnsupportedWord,
  kWordTwice,
  kSameGroup,
  kWordNotUsed,
  kWordMissing,
  kWordNegative,
  kWordRange,
  kTwoAxisUsers,
  kNoMotionMode,
  kAxesMissing,
  kPolarWithAxis,
  kPolarAtOrigin,
  kLineAfterOWord,
  // Meaning.
  kFeedRateZero,
  kFeedRateMissing,
  kG53WithoutLine,
  kG53Incremental,
  kArcWithoutCentre,
  kArcEndMissing,
  kArcWrongOffset,
  kArcCentreMissing,
  kArcZeroRadius,
  kArcRadiusTooSmall,
  kArcFullCircleWithRadius,
  kArcRadiiDiffer,
  kCycleInverseTime,
  kCycleRotaryAxis,
  kCycleDepth,
  kCycleDepthMissing,
  kCycleClearanceMissing,
  kTapSpindle,
  kToolUnknown,
  kWaitMode,
  kWaitTimeout,
  // The course of the program.
  kAborted,
  kUnknownKeyword,
  kTooManyOWords,
  kBlockNotClosed,
  kBlockMismatch,
  kSubroutineNested,
  kSubroutineTwice,
  kSubroutineUnknown,
  kSubroutineNotCalled,
  kProgramNotCalled,
  kReturnOfSubroutine,
  kSubprogramNotEnded,
  kComputedLabel,
  kReturnOutsideSubroutine,
  kLoopUnknown,
  kCallTooDeep,
  kNoSavedState,
  kTooManyArguments,
  kTooManyRepeats,
};

struct Error {
  ErrorCode code{};
  std::uint32_t line = 0;    // 1 is the first line of the program
  std::uint16_t column = 0;  // 1 is the first character; 0: the line as a whole
  char letter = '\0';        // of the word that the error concerns, in upper case; '\0': none. kBadCharacter: it
  std::int32_t tenths = -1;  // ten times the number of that code, 411 for G41.1; below 0: none
};

// What went wrong; nothing if all is well.
using Failure = std::optional<Error>;

// What is wrong, as a sentence without the place and the code.
[[nodiscard]] std::string_view text_of(ErrorCode code) noexcept;

// The same behind the code: `G41.1: the code is not supported`.
using ErrorText = FixedText<128>;
[[nodiscard]] ErrorText message_of(const Error& error) noexcept;

}  // namespace armature::gcode
