// The loops of `Kernel`, compiled once for each vector unit: the file that includes this has set the target and has named
// ZMPWALK_KERNEL. Nothing here may come from a header: a function that two builds share would be linked in one build's form,
// and that form may not run on this processor.

namespace zmpwalk {
namespace {

/// Four numbers side by side: one register, or two of a plainer vector unit.
typedef double Row __attribute__((vector_size(32), aligned(8), may_alias));

#pragma GCC diagnostic ignored "-Wpsabi"  // no Row crosses a call: all of this is inlined
inline Row all(double a) { return Row{a, a, a, a}; }

void subtract_product(int n, const double* J, const double* v, double* out) {
  double sum[6] = {0, 0, 0, 0, 0, 0};
  for (int j = 0; j < n; ++j, J += 6)
    for (int i = 0; i < 6; ++i) sum[i] += J[i] * v[j];
  for (int i = 0; i < 6; ++i) out[i] -= sum[i];
}

double solve_leg(double* system) {
  Row(*rows)[3] = reinterpret_cast<Row(*)[3]>(system);  // six of M, two of padding, four of Y
  const auto entry = [&](int i, int j) -> double& { return system[12 * i + j]; };
  double least = __builtin_inf();
  for (int k = 0; k < 6; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 6; ++i)
      if (__builtin_fabs(entry(i, k)) > __builtin_fabs(entry(pivot, k))) pivot = i;
    const double size = __builtin_fabs(entry(pivot, k));
    if (!(size > 0.0)) return 0.0;
    if (size < least) least = size;
    if (pivot != k)
      for (int c = 0; c < 3; ++c) {
        const Row kept = rows[k][c];
        rows[k][c] = rows[pivot][c];
        rows[pivot][c] = kept;
      }
    const Row inverse = all(1.0 / entry(k, k));
    for (int c = 0; c < 3; ++c) rows[k][c] *= inverse;
    for (int i = k + 1; i < 6; ++i) {
      const Row factor = all(entry(i, k));
      for (int c = 0; c < 3; ++c) rows[i][c] -= factor * rows[k][c];
    }
  }
  for (int k = 5; k > 0; --k)
    for (int i = 0; i < k; ++i) rows[i][2] -= all(entry(i, k)) * rows[k][2];
  return least;
}

void multiply(int n, const double* A, const int* spans, const double* X, double* Y) {
  const Row* x = reinterpret_cast<const Row*>(X);
  Row* y = reinterpret_cast<Row*>(Y);
  int i = 0;
  for (; i + 3 < n; i += 4) {  // four rows at a time, so that additions need not wait for each other
    const double* a = A + i * n;
    Row sum[4] = {all(0), all(0), all(0), all(0)};
    for (int count = *spans++; count > 0; --count, spans += 2)
      for (int j = spans[0]; j < spans[1]; ++j)
        for (int r = 0; r < 4; ++r) sum[r] += all(a[r * n + j]) * x[j];
    for (int r = 0; r < 4; ++r) y[i + r] = sum[r];
  }
  for (; i < n; ++i) {
    Row sum = all(0);
    for (int count = *spans++; count > 0; --count, spans += 2)
      for (int j = spans[0]; j < spans[1]; ++j) sum += all(A[i * n + j]) * x[j];
    y[i] = sum;
  }
}

void joint_torque(int n, const double* w, const double* at, const double* J_left, const double* f_left,
                  const double* J_right, const double* f_right, double* tau) {
  for (int j = 0; j < n; ++j) {
    double sum = 0.0;
    for (int c = 0; c < 4; ++c) sum += w[4 * j + c] * at[c];
    for (int i = 0; i < 6; ++i) sum += J_left[6 * j + i] * f_left[i] + J_right[6 * j + i] * f_right[i];
    tau[j] = sum;
  }
}

}  // namespace

extern const Kernel ZMPWALK_KERNEL;
const Kernel ZMPWALK_KERNEL{ZMPWALK_KERNEL_NAME, subtract_product, solve_leg, multiply, joint_torque};

}  // namespace zmpwalk
