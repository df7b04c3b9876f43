#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

namespace zmpwalk {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Vec12 = Eigen::Matrix<double, 12, 1>;
using VecX = Eigen::VectorXd;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat3X = Eigen::Matrix<double, 3, Eigen::Dynamic>;
using Mat6X = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using MatX = Eigen::MatrixXd;
using MatX3 = Eigen::Matrix<double, Eigen::Dynamic, 3>;
/// Row-major, as NumPy and MuJoCo lay matrices out.
using RowMatX = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

using ConstVecRef = Eigen::Ref<const VecX>;
using ConstMatRef = Eigen::Ref<const RowMatX>;

/// Not-a-number: a setting that was not set, or a result that does not exist.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The two feet. Every array that has an entry for each foot has them in this order.
enum Side : int { kLeft = 0, kRight = 1 };
inline constexpr std::array<Side, 2> kSides{kLeft, kRight};
inline constexpr Side other(Side side) { return side == kLeft ? kRight : kLeft; }
/// +1 for the left, -1 for the right: the sign of y on that side.
inline constexpr double side_sign(Side side) { return side == kLeft ? 1.0 : -1.0; }

/// Cross-product matrix: skew(a) * b = a x b.
inline Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace zmpwalk
