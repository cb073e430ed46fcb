// Exponential, logarithm and power for expressions of programs, with the same bits on every machine.
//
// The relative error of exponential and logarithm is below 1e-15 near 1 and grows with the result's exponent to 1e-13;
// a program needs 1e-9. Powers with whole exponents up to 64 are products.
#pragma once

namespace armature::gcode {

// Any x; 0 below -745, infinite above 709.78.
[[nodiscard]] double exponential(double x) noexcept;
// x > 0 and finite.
[[nodiscard]] double logarithm(double x) noexcept;
// A negative base needs a whole exponent. 0 to a negative power is infinite.
[[nodiscard]] double power(double base, double exponent) noexcept;

}  // namespace armature::gcode
