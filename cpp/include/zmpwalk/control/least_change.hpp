#pragma once

#include <memory>
#include <vector>

#include "zmpwalk/math/types.hpp"

namespace zmpwalk {

/// The least y that satisfies inequalities: minimise y' y / 2 subject to c_i + C_i y >= 0 for each row i.
///
/// y = 0 is the minimum without rows, and few rows are broken there. A dual active-set method (Goldfarb and Idnani, Mathematical
/// Programming 27, 1983) fits that: it starts at y = 0 and takes up one broken row after the other, as RtEiquadprog of eiquadprog does,
/// on matrices of fixed size. There is no start nearer than y = 0 that would be worth its checks: a row costs about 0.4 us.
///
/// Rows should be of one size, so that c_i says how near each is. The method gets the rows that are nearest to being broken, 64 of
/// them for few unknowns and 128 for many; the others are checked afterwards.
class LeastChange {
 public:
  static constexpr int kMost = 24;     ///< unknowns
  static constexpr int kFew = 12;      ///< unknowns up to which the method takes half the time
  static constexpr int kPasses = 100;  ///< of the method, at most; each takes up a row or lets one go

  /// @param rows  that may be added at most
  explicit LeastChange(int rows);
  ~LeastChange();
  LeastChange(const LeastChange&) = delete;
  LeastChange& operator=(const LeastChange&) = delete;

  /// Forgets all rows. @param unknowns  1..kMost. Allocates nothing, and nor do the others.
  void begin(int unknowns);
  /// Adds a row and returns its number; its entries follow in the reference that `row` gives.
  int add(double c);
  /// Entries of a row (unknowns,).
  Eigen::Ref<Eigen::RowVectorXd> row(int i);
  double c(int i) const { return c_[i]; }
  int rows() const { return rows_; }

  /// Finds y. False where no y satisfies all rows, or `kPasses` were not enough; y is then not to be used.
  bool solve();
  /// (unknowns,)
  Eigen::Ref<const VecX> y() const;
  /// True where row i holds y back: it is met with equality, and y would be smaller without it.
  bool is_active(int i) const { return active_[static_cast<std::size_t>(i)]; }
  /// Passes that the last `solve` took.
  int passes() const { return passes_; }

 private:
  template <int N, int M>
  struct Method;
  using Few = Method<kFew, 64>;
  using Many = Method<kMost, 128>;
  template <int N, int M>
  bool solve(Method<N, M>& method);

  int capacity_, unknowns_ = 0, rows_ = 0, passes_ = 0;
  bool left_out_ = false;  // a row that the method did not get is broken
  RowMatX C_;
  VecX c_, y_;
  std::vector<int> order_;
  std::vector<bool> active_;
  std::unique_ptr<Few> few_;
  std::unique_ptr<Many> many_;
};

}  // namespace zmpwalk
