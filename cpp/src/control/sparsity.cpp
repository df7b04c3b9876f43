#include "zmpwalk/control/sparsity.hpp"

namespace zmpwalk {

template <class Related>
Sparsity::Sparsity(int n, Related related) {
  for (int first = 0, rows; first < n; first += rows) {
    rows = first + 4 <= n ? 4 : 1;
    const std::size_t count = spans_.size();
    spans_.push_back(0);
    bool inside = false;
    for (int j = 0; j <= n; ++j) {
      bool any = false;
      for (int i = first; j < n && i < first + rows; ++i) any = any || related(i, j);
      if (any != inside) spans_.push_back(j);
      if (any && !inside) ++spans_[count];
      inside = any;
    }
  }
}

Sparsity::Sparsity(int n) : Sparsity(n, [](int, int) { return true; }) {}

Sparsity Sparsity::of_tree(const std::vector<int>& parent) {
  const auto moves = [&](int i, int j) {  // i is on the way from j to the root
    while (j > i) j = parent[j];
    return i == j;
  };
  return Sparsity(static_cast<int>(parent.size()), [&](int i, int j) { return moves(i, j) || moves(j, i); });
}

}  // namespace zmpwalk
