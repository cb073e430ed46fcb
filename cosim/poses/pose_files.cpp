#include "cosim/poses/pose_files.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "controller/base/angle_units.hpp"
#include "cosim/poses/number_csv.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kMatrixColumns = 12;

CsvLayout joint_columns(std::string_view before, std::size_t joints) {
  CsvLayout layout;
  for (std::size_t i = 0; i < joints; ++i) {
    layout.push_back({fmt::format("{}{}_deg", before, i + 1), kMaxJointDeg, "deg"});
  }
  return layout;
}

// t11 .. t34, row by row; the fourth column is the position.
CsvLayout matrix_columns() {
  CsvLayout layout;
  for (std::size_t i = 0; i < kMatrixColumns; ++i) {
    const bool position = i % 4 == 3;
    // No tighter range for the rotation: the check of the whole matrix gives a better message.
    layout.push_back({fmt::format("t{}{}", i / 4 + 1, i % 4 + 1), kMaxPositionMm, position ? "mm" : ""});
  }
  return layout;
}

Transform transform_of(std::span<const double> values) {
  const auto element = [values](int row, int column) {
    return values[std::size_t{4} * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
  };
  Transform pose;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.rotation(row, column) = element(row, column);
    pose.position_mm(row) = element(row, 3);
  }
  return pose;
}

void append_number(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0).ptr;  // -0 as 0
  text.append(digits.data(), end);
}

void append_integer(std::string& text, std::size_t value) {
  std::array<char, 24> digits{};
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

// Six decimals. A smaller value keeps its digits.
std::string size_text(double value) {
  constexpr double kSmallest = 1e-6;
  return value >= kSmallest ? fixed_text(value, 6) : number_text(value);
}

}  // namespace

std::optional<std::string> rotation_problem(const Eigen::Matrix3d& rotation) {
  if (is_rigid({rotation, Eigen::Vector3d::Zero()})) return std::nullopt;
  const double off = (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (off <= kRotationTolerance && rotation.determinant() < 0) {
    return "it is a reflection: determinant -1, expected +1";
  }
  const Eigen::Vector3d third = rotation.col(0).cross(rotation.col(1)) - rotation.col(2);
  return fmt::format("its columns are not orthonormal: off by {:.3g}, allowed is {}",
                     std::max(off, third.cwiseAbs().maxCoeff()), number_text(kRotationTolerance));
}

std::vector<PerAxis<double>> parse_joints(std::string_view text, const std::string& name, std::size_t joints) {
  std::vector<PerAxis<double>> rows;
  const std::array layouts{joint_columns("j", joints)};
  read_number_csv(text, name, layouts, [&](const NumberRow& row, CsvProblems&) {
    PerAxis<double>& angles = rows.emplace_back();
    for (std::size_t i = 0; i < joints; ++i) angles[i] = row.values[i];
  });
  return rows;
}

std::vector<PoseRow> parse_poses(std::string_view text, const std::string& name, std::size_t joints) {
  std::vector<PoseRow> rows;
  CsvLayout with_previous = matrix_columns();
  for (CsvColumn& column : joint_columns("prev", joints)) with_previous.push_back(std::move(column));
  const std::array layouts{matrix_columns(), with_previous};
  read_number_csv(text, name, layouts, [&](const NumberRow& row, CsvProblems& problems) {
    PoseRow pose{transform_of(row.values), {}};
    if (const auto problem = rotation_problem(pose.pose.rotation)) {
      problems.add(row.line, row.columns[0], {}, fmt::format("expected a rotation in t11 .. t33, but {}", *problem));
      return;
    }
    for (std::size_t i = kMatrixColumns; i < row.values.size(); ++i) {
      pose.previous_deg[i - kMatrixColumns] = row.values[i];
    }
    rows.push_back(pose);
  });
  return rows;
}

std::string poses_text(std::span<const Transform> poses) {
  std::string text = header_of(matrix_columns()) + "\n";
  for (const Transform& pose : poses) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        append_number(text, pose.rotation(row, column));
        text += ',';
      }
      append_number(text, pose.position_mm(row));
      text += row < 2 ? ',' : '\n';
    }
  }
  return text;
}

std::string no_solution_text(const IkSolutions& solutions) {
  if (solutions.status == IkStatus::kUnreachable)
    return fmt::format("unreachable by {} mm", size_text(solutions.margin_mm));
  if (solutions.status == IkStatus::kOrientation) {
    return fmt::format("orientation off by {} deg", size_text(solutions.residual_rad * kDegPerRad));
  }
  // Poses of files are rigid, but a user frame or a tool can shift one beyond the largest position.
  if (solutions.status == IkStatus::kInvalidInput) {
    return fmt::format("not a rigid pose within {} mm of the base", number_text(kMaxPositionMm));
  }
  throw std::logic_error{
      fmt::format("no branch, but the status of the inverse kinematics is {}", static_cast<int>(solutions.status))};
}

SolutionsText::SolutionsText(std::size_t joints)
    : joints_{joints},
      text_{"pose,branch,shoulder,elbow,flip,singular,within_limits,selected," + header_of(joint_columns("j", joints)) +
            "\n"} {}

void SolutionsText::add(const IkSolutions& solutions) {
  for (std::size_t i = 0; i < solutions.count; ++i) add_branch(i, solutions);
  if (solutions.count == 0) {
    append_integer(text_, poses_);
    text_ += ",none," + no_solution_text(solutions);
    text_.append(5 + joints_, ',');
    text_ += '\n';
  }
  ++poses_;
}

void SolutionsText::add_branch(std::size_t branch, const IkSolutions& solutions) {
  const IkBranch& b = solutions.branches[branch];
  const auto flag = [this](int value) { text_.append(",").append(value < 0 ? "-1" : value > 0 ? "1" : "0"); };
  append_integer(text_, poses_);
  text_ += ',';
  append_integer(text_, branch);
  flag(b.shoulder);
  flag(b.elbow);
  flag(b.flip);
  text_ += ',';
  append_integer(text_, b.singular);
  flag(b.within_limits ? 1 : 0);
  flag(static_cast<int>(branch) == solutions.selected ? 1 : 0);
  for (std::size_t i = 0; i < joints_; ++i) {
    text_ += ',';
    append_number(text_, b.joints[i].value() * kDegPerRad);
  }
  text_ += '\n';
}

}  // namespace armature::cosim
