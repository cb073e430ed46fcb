// The status of a reply for the reason why the dispatcher refused a command.
#pragma once

#include "controller/message/move_refused.hpp"
#include "controller/pendant/protocol/frame_table.hpp"

namespace armature::pendant {

[[nodiscard]] constexpr Status status_of(Refusal reason) noexcept {
  switch (reason) {
    case Refusal::kOutsideLimits:
      return Status::kSoftLimit;
    case Refusal::kInvalidTarget:
      return Status::kRange;
    case Refusal::kNotReady:
    case Refusal::kQueueFull:
    case Refusal::kReplaced:
    case Refusal::kInputTimeout:
    case Refusal::kPartLost:
    case Refusal::kBeltTooFast:
    case Refusal::kNotReferenced:
      return Status::kBusy;
    case Refusal::kNoKinematics:
    case Refusal::kNoJerkLimit:
    case Refusal::kUnreachable:
    case Refusal::kOrientation:
    case Refusal::kSingular:
    case Refusal::kTooFast:
    case Refusal::kNoCircle:
    case Refusal::kChainRefused:
    case Refusal::kConfiguration:
    case Refusal::kNoSpline:
    case Refusal::kOutputOutside:
      return Status::kIkFail;
  }
  return Status::kIkFail;
}

}  // namespace armature::pendant
