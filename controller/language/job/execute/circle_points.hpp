// The circle through three taught points.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace armature::job {

struct ArcMiddles {
  Eigen::Vector3d first_mm = Eigen::Vector3d::Zero();   // of the arc from the first point to the second
  Eigen::Vector3d second_mm = Eigen::Vector3d::Zero();  // of the arc from the second point to the third
};

// On the circle on which one comes from the first point over the second to the third in less than a turn. Nothing if
// the points are on one line, nearer to it than a millionth of their distance, or two successive ones are equal. The
// third may be the first: then nothing determines the plane either.
[[nodiscard]] std::optional<ArcMiddles> middles_of_arcs(const Eigen::Vector3d& first_mm,
                                                        const Eigen::Vector3d& second_mm,
                                                        const Eigen::Vector3d& third_mm) noexcept;

}  // namespace armature::job
