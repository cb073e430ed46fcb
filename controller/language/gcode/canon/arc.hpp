// The geometry of arcs in a plane.
#pragma once

#include <optional>
#include <variant>

#include "controller/language/gcode/reader/error.hpp"

namespace armature::gcode {

struct PlanePoint {
  double first = 0.0;
  double second = 0.0;
};

// Either the centre or the error.
using ArcCentre = std::variant<PlanePoint, ErrorCode>;

// Of the arc from `start` to `end` with a radius. A negative radius requests the longer arc.
[[nodiscard]] ArcCentre centre_from_radius(PlanePoint start, PlanePoint end, double radius, bool clockwise,
                                           double tolerance_mm) noexcept;

// Whether start and end have the same distance from the centre, within the tolerance rule: an error if the difference
// is above 100 tolerances, or above one tolerance and above 0.1 % of the larger radius.
[[nodiscard]] std::optional<ErrorCode> check_centre(PlanePoint start, PlanePoint end, PlanePoint centre,
                                                    double tolerance_mm) noexcept;

// Length of the arc within the plane, with `turns` full and partial turns, above 0, and with the radius at its start.
[[nodiscard]] double arc_length(PlanePoint start, PlanePoint end, PlanePoint centre, bool clockwise,
                                int turns) noexcept;

// The angle of that arc, in (0, 2 pi turns]. Equal start and end: full turns.
[[nodiscard]] double arc_angle(PlanePoint start, PlanePoint end, PlanePoint centre, bool clockwise, int turns) noexcept;

}  // namespace armature::gcode
