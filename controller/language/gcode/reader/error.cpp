#include "controller/language/gcode/reader/error.hpp"

#include "controller/language/gcode/reader/code_table.hpp"
#include "controller/language/gcode/reader/source_line.hpp"

namespace armature::gcode {

// A switch without a default: the compiler names a code that has no text.
std::string_view text_of(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kLineTooLong:
      return "the line has more than 255 characters";
    case ErrorCode::kBadCharacter:
      return "this character has no meaning here";
    case ErrorCode::kCommentNotClosed:
      return "the comment is not closed with ')'";
    case ErrorCode::kNestedComment:
      return "a comment must not contain '('";
    case ErrorCode::kNumberExpected:
      return "a number was expected";
    case ErrorCode::kNumberTooLong:
      return "the number has more than 18 digits";
    case ErrorCode::kValueExpected:
      return "a number, '#', '[' or a function was expected";
    case ErrorCode::kBracketExpected:
      return "'[' was expected";
    case ErrorCode::kBracketNotClosed:
      return "']' is missing";
    case ErrorCode::kTooDeep:
      return "brackets, '#' and signs are nested more than 32 deep";
    case ErrorCode::kUnknownFunction:
      return "the function is unknown";
    case ErrorCode::kOperatorExpected:
      return "an operator or ']' was expected";
    case ErrorCode::kSlashExpected:
      return "ATAN needs two values: ATAN[y]/[x]";
    case ErrorCode::kNameNotClosed:
      return "the name is not closed with '>'";
    case ErrorCode::kNameTooLong:
      return "the name has more than 47 characters";
    case ErrorCode::kEqualSignExpected:
      return "'=' was expected after the parameter";
    case ErrorCode::kNotAnInteger:
      return "a whole number was expected";
    case ErrorCode::kTooManyAssignments:
      return "the line sets more than 50 parameters";
    case ErrorCode::kDivisionByZero:
      return "division by zero";
    case ErrorCode::kOutsideDomain:
      return "the function is not defined for this value";
    case ErrorCode::kValueTooLarge:
      return "the value is too large";
    case ErrorCode::kParameterNumber:
      return "parameters have the numbers 1 to 5602";
    case ErrorCode::kParameterUndefined:
      return "the named parameter has no value";
    case ErrorCode::kParameterReadOnly:
      return "the parameter can only be read";
    case ErrorCode::kTooManyNames:
      return "more than 256 named parameters exist";
    case ErrorCode::kUnknownCode:
      return "the code is unknown";
    case ErrorCode::kUnsupportedCode:
      return "the code is not supported";
    case ErrorCode::kCodeNotFirst:
      return "the code must stand first in its line, with nothing behind its words";
    case ErrorCode::kUnsupportedWord:
      return "words with this letter are not supported";
    case ErrorCode::kWordTwice:
      return "the line has two words with this letter";
    case ErrorCode::kSameGroup:
      return "the line has two codes of the same modal group";
    case ErrorCode::kWordNotUsed:
      return "no code of the line uses this word";
    case ErrorCode::kWordMissing:
      return "a word that the code needs is missing";
    case ErrorCode::kWordNegative:
      return "the value must not be negative";
    case ErrorCode::kWordRange:
      return "the value of the word is out of range";
    case ErrorCode::kTwoAxisUsers:
      return "two codes of the line use the axis words";
    case ErrorCode::kNoMotionMode:
      return "the line has axis words, but no motion code is active";
    case ErrorCode::kAxesMissing:
      return "the code needs an axis word";
    case ErrorCode::kPolarWithAxis:
      return "a polar place (@ ^) must not have X or Y besides";
    case ErrorCode::kPolarAtOrigin:
      return "a polar place needs its angle ^ while the tool is at the origin";
    case ErrorCode::kLineAfterOWord:
      return "nothing may follow on a line with an O-word";
    case ErrorCode::kFeedRateZero:
      return "the feed rate is zero";
    case ErrorCode::kFeedRateMissing:
      return "each motion with inverse time feed needs an F word above zero";
    case ErrorCode::kG53WithoutLine:
      return "G53 needs G0 or G1";
    case ErrorCode::kG53Incremental:
      return "G53 is not possible with incremental distances";
    case ErrorCode::kArcWithoutCentre:
      return "the arc has neither a radius nor a centre";
    case ErrorCode::kArcEndMissing:
      return "the arc has no end in its plane";
    case ErrorCode::kArcWrongOffset:
      return "the centre of the arc has a word outside its plane";
    case ErrorCode::kArcCentreMissing:
      return "an absolute centre needs both of its words";
    case ErrorCode::kArcZeroRadius:
      return "the radius of the arc is zero";
    case ErrorCode::kArcRadiusTooSmall:
      return "the radius is too small to reach the end of the arc";
    case ErrorCode::kArcFullCircleWithRadius:
      return "an arc with a radius must not end where it starts";
    case ErrorCode::kArcRadiiDiffer:
      return "the radii at the start and the end of the arc differ too much";
    case ErrorCode::kCycleInverseTime:
      return "a cycle is not possible with inverse time feed";
    case ErrorCode::kCycleRotaryAxis:
      return "a cycle must not move A, B or C";
    case ErrorCode::kCycleDepth:
      return "the clearance plane R lies below the bottom of the hole";
    case ErrorCode::kCycleDepthMissing:
      return "the cycle has no bottom of the hole";
    case ErrorCode::kCycleClearanceMissing:
      return "the cycle has no clearance plane R";
    case ErrorCode::kTapSpindle:
      return "tapping needs a spindle that turns: M3 for G84, M4 for G74";
    case ErrorCode::kToolUnknown:
      return "the tool is not in the tool table";
    case ErrorCode::kWaitMode:
      return "an analog input can only be read at once (L0)";
    case ErrorCode::kWaitTimeout:
      return "a wait needs a time-out Q above zero";
    case ErrorCode::kAborted:
      return "the program stops itself with (ABORT, ...)";
    case ErrorCode::kUnknownKeyword:
      return "the keyword of the O-word is unknown";
    case ErrorCode::kTooManyOWords:
      return "the program has more than 1024 O-words or 256 names of them";
    case ErrorCode::kBlockNotClosed:
      return "the block is not closed";
    case ErrorCode::kBlockMismatch:
      return "the O-word does not belong to the innermost open block";
    case ErrorCode::kSubroutineNested:
      return "a subroutine must not be defined within a block";
    case ErrorCode::kSubroutineTwice:
      return "the subroutine is defined twice";
    case ErrorCode::kSubroutineUnknown:
      return "the subroutine is neither in this program nor in a file beside it";
    case ErrorCode::kSubroutineNotCalled:
      return "a subroutine that begins with SUB is called with CALL";
    case ErrorCode::kProgramNotCalled:
      return "a subprogram that begins with its O-number alone is called with M98";
    case ErrorCode::kReturnOfSubroutine:
      return "a subroutine that begins with SUB ends with ENDSUB or RETURN";
    case ErrorCode::kSubprogramNotEnded:
      return "the subprogram ends without M99";
    case ErrorCode::kComputedLabel:
      return "only CALL may have a computed O-number";
    case ErrorCode::kReturnOutsideSubroutine:
      return "RETURN stands outside a subroutine";
    case ErrorCode::kLoopUnknown:
      return "no loop with this number is open here";
    case ErrorCode::kCallTooDeep:
      return "subroutine calls are nested more than 10 deep";
    case ErrorCode::kNoSavedState:
      return "no modal state was saved with M70 or M73 here";
    case ErrorCode::kTooManyArguments:
      return "a call has more than 30 arguments";
    case ErrorCode::kTooManyRepeats:
      return "REPEAT blocks are nested more than 64 deep";
  }
  return "unknown error";
}

ErrorText message_of(const Error& error) noexcept {
  ErrorText text;
  if (error.code == ErrorCode::kBadCharacter) {
    const auto byte = static_cast<unsigned char>(error.letter);
    if (byte > ' ' && byte <= '~') {
      text << '\'' << error.letter << "' has no meaning here";
    } else {
      text << "the byte " << static_cast<std::uint32_t>(byte) << " has no meaning here";
    }
    return text;
  }
  if (error.letter != '\0') {
    text << error.letter;
    if (error.tenths >= 0) text << error.tenths / 10;
    if (error.tenths > 0 && error.tenths % 10 != 0) text << '.' << error.tenths % 10;
    text << ": ";
  }
  text << text_of(error.code);
  const bool named = error.code == ErrorCode::kUnsupportedCode;
  const CodeInfo* const info = named ? find_code(to_lower(error.letter), error.tenths) : nullptr;
  if (info != nullptr) text << ": " << info->meaning;
  return text;
}

}  // namespace armature::gcode
