#pragma once

#include <vector>

namespace zmpwalk {

/// Which entries of a symmetric matrix may differ from zero, in the form in which `Kernel::multiply` reads it.
///
/// Two legs do not accelerate each other but through the base: almost half of a humanoid's inertia is zero for that reason.
class Sparsity {
 public:
  /// Every entry of an (n, n) matrix.
  explicit Sparsity(int n);
  /// The inertia of a tree: entry (i, j) belongs to coordinates of which one moves the other's body, so that one is before the other on a way
  /// to the root.
  /// @param parent  the coordinate before each on the way to the root, -1 where there is none; smaller than its own (n,)
  static Sparsity of_tree(const std::vector<int>& parent);

  /// For each four rows, then for each row that is left over: the number of spans, and first and past-the-end column of each.
  const int* spans() const { return spans_.data(); }

 private:
  template <class Related>
  Sparsity(int n, Related related);

  std::vector<int> spans_;
};

}  // namespace zmpwalk
