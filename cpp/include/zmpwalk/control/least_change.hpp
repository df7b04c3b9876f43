#pragma once

#include <array>
#include <memory>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// The least y that satisfies inequalities: minimise y' y / 2 subject to c_i + C_i y >= 0 for each row i.
///
/// y = 0 is the minimum without rows, and few rows are broken there. A dual active-set method (Goldfarb and Idnani, Mathematical
/// Programming 27, 1983) fits that: it starts at y = 0 and takes up one broken row after the other, as RtEiquadprog of eiquadprog does,
/// on matrices of fixed size. There is no start nearer than y = 0 that would be worth its checks: a row costs about 0.4 us.
///
/// Rows should be of one size, so that c_i says how near each is to being broken.
class LeastChange {
 public:
  static constexpr int kUnknowns = 13;  ///< an unknown that no row names stays zero
  static constexpr int kRows = 90;      ///< that may be added
  static constexpr int kPasses = 60;    ///< of the method, at most; each takes up a row and may let others go
  using Y = Eigen::Matrix<double, kUnknowns, 1>;
  using Row = Eigen::Matrix<double, 1, kUnknowns>;

  LeastChange();
  ~LeastChange();
  LeastChange(const LeastChange&) = delete;
  LeastChange& operator=(const LeastChange&) = delete;

  /// Forgets all rows. Allocates nothing, and nor do the others.
  void begin();
  /// Adds the row c + C y >= 0 and returns its number. @throws InputError  there are `kRows` already
  int add(double c, const Row& C);
  int rows() const { return rows_; }

  /// Finds y. False where no y satisfies all rows, or `kPasses` were not enough; y is then not to be used.
  bool solve();
  const Y& y() const;
  /// True where row i holds y back: it is met with equality, and y would be smaller without it.
  bool is_active(int i) const { return active_[static_cast<std::size_t>(i)]; }
  /// Passes that the last `solve` took.
  int passes() const;

 private:
  struct Method;
  int rows_ = 0;
  std::array<bool, kRows> active_{};
  std::unique_ptr<Method> method_;
};

}  // namespace zmpwalk
