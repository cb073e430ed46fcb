// "Did you mean": the known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace armature::cosim {

// The known name that `typed` most likely means, empty when none is near: a spelling mistake (edit distance with
// transpositions, at most a third of the length), or a forgotten or wrong ending such as `target` for `target_deg`.
[[nodiscard]] std::string_view nearest_name(std::string_view typed, std::span<const std::string_view> known);

// `, did you mean NAME?` when one is near, else `; known: A, B, C` (or nothing when nothing is known).
[[nodiscard]] std::string suggestion(std::string_view typed, std::span<const std::string_view> known);
[[nodiscard]] std::string suggestion(std::string_view typed, std::span<const std::string> known);

}  // namespace armature::cosim
