#pragma once

#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <limits>
#include <random>
#include <string>

#include "zmpwalk/math/types.hpp"

// What every test needs: largest differences that cannot hide a NaN, messages of exceptions, seeded numbers.

namespace zmpwalk::testing {

/// Largest |entry|; infinity where one is not finite, so that no comparison passes by NaN.
template <class Derived>
double largest(const Eigen::DenseBase<Derived>& a) {
  const Eigen::MatrixXd values = a.derived();
  if (!values.allFinite()) return std::numeric_limits<double>::infinity();
  return values.size() ? values.cwiseAbs().maxCoeff() : 0.0;
}

/// Largest difference of two arrays; infinity where their shapes differ.
template <class A, class B>
double gap(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return std::numeric_limits<double>::infinity();
  return largest(a - b);
}
inline double gap(double a, double b) { return largest(Eigen::Matrix<double, 1, 1>(a - b)); }

/// Seeded numbers, the same with every standard library.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
  VecX vector(long n, double size) {
    return VecX::NullaryExpr(n, [&] { return uniform(-size, size); });
  }

 private:
  std::mt19937 engine_;
};

}  // namespace zmpwalk::testing

/// Two numbers or arrays agree within `tolerance` in every entry.
#define CHECK_NEAR(a, b, tolerance) BOOST_CHECK_LE(::zmpwalk::testing::gap(a, b), tolerance)

/// `expression` throws `Type`, and its message holds `text`.
#define CHECK_THROWS(expression, Type, text)                                      \
  BOOST_CHECK_EXCEPTION(expression, Type, [&](const Type& error) {                \
    const bool found = std::string(error.what()).find(text) != std::string::npos; \
    if (!found) BOOST_TEST_MESSAGE("the message was: " << error.what());          \
    return found;                                                                 \
  })
