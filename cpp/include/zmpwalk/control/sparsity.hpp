#pragma once

#include <vector>

namespace zmpwalk {

/// Says which entries of a symmetric matrix may differ from zero, in the form that `Kernel::multiply` reads.
///
/// Two legs accelerate each other only through the base. For this reason almost half of the entries of a humanoid's inertia are zero.
class Sparsity {
 public:
  /// Every entry of an (n, n) matrix.
  explicit Sparsity(int n);
  /// The inertia of a tree of bodies: entry (i, j) may differ from zero only where one of the two coordinates is on the other's way to the root.
  /// @param parent  for each coordinate the next one on its way to the root, which is smaller than its own; -1 where there is none (n,)
  static Sparsity of_tree(const std::vector<int>& parent);

  /// For each group of four rows, and then for each row that is left over: the number of spans, and for each span its first column and the column
  /// after its last.
  const int* spans() const { return spans_.data(); }

 private:
  template <class Related>
  Sparsity(int n, Related related);

  std::vector<int> spans_;
};

}  // namespace zmpwalk
