#include "controller/language/job/execute/move_tags.hpp"

#include <algorithm>
#include <array>

namespace armature::job {
namespace {

struct TagOfMove {
  TagName name;
  std::optional<double> MoveTags::*value;
  double unit;  // what 1 of a variable means
  double least, most;
};
constexpr std::array kTagsOfMoves{TagOfMove{TagName::kVj, &MoveTags::vj, 0.01, 0.01, 100.0},
                                  TagOfMove{TagName::kV, &MoveTags::v, 0.1, 0.1, 30'000.0},
                                  TagOfMove{TagName::kVr, &MoveTags::vr, 0.1, 0.1, 1'000.0},
                                  TagOfMove{TagName::kPl, &MoveTags::pl, 1.0, 0.0, MoveTags::kMaxPl},
                                  TagOfMove{TagName::kCr, &MoveTags::cr, 1.0, 0.0, 1'000.0},
                                  TagOfMove{TagName::kAcc, &MoveTags::acc, 1.0, 1.0, 100.0},
                                  TagOfMove{TagName::kDec, &MoveTags::dec, 1.0, 1.0, 100.0}};

}  // namespace

double MoveTags::accel_share() const noexcept {
  return std::min(acc.value_or(100.0), dec.value_or(100.0)) / 100.0;
}

bool read_tags(Step& step, OperandReader operands, MoveTags& tags) noexcept {
  while (!operands.at_end()) {
    if (!operands.is(OperandKind::kTag)) {
      operands.skip();
      continue;
    }
    const auto name = static_cast<TagName>(operands.here().what);
    const auto* const tag = std::ranges::find(kTagsOfMoves, name, &TagOfMove::name);
    const bool known = tag != kTagsOfMoves.end();
    double value = 0.0;
    if (!operands.tag(known ? tag->unit : 1.0, value)) return false;
    if (!known) return step.fail(Alarm::kUnsupported);
    tags.*tag->value = value;
  }
  for (const TagOfMove& tag : kTagsOfMoves) {
    const std::optional<double>& value = tags.*tag.value;
    if (value && !(*value >= tag.least && *value <= tag.most)) return step.fail(Alarm::kRange);
  }
  return true;
}

}  // namespace armature::job
