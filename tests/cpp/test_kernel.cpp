#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <random>

#include "testing.hpp"
#include "zmpwalk/control/kernel_choice.hpp"
#include "zmpwalk/control/sparsity.hpp"
#include "zmpwalk/math/error.hpp"
#include "zmpwalk/math/types.hpp"

using namespace zmpwalk;

namespace {

using Rows4 = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;
using System = Eigen::Matrix<double, 6, 12, Eigen::RowMajor>;
constexpr double kRounding = 1e-12;
constexpr int kSizes[] = {18, 19, 20, 21, 31, 66};  // all remainders of blocks of four rows

MatX random_matrix(int rows, int columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return MatX::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

System system_of(const Mat6& M, const Eigen::Matrix<double, 6, 4>& R) {
  System out = System::Zero();
  out.leftCols<6>() = M;
  out.rightCols<4>() = R;
  return out;
}

}  // namespace

BOOST_AUTO_TEST_CASE(first_build_runs_everywhere_and_auto_takes_the_last) {
  BOOST_REQUIRE(!kernels().empty());
#ifdef __x86_64__
  BOOST_CHECK_EQUAL(kernels().front()->name, "x86-64");
#endif
  BOOST_CHECK_EQUAL(&kernel(), kernels().back());
  for (const Kernel* k : kernels()) BOOST_CHECK_EQUAL(&kernel(k->name), k);
}

#ifdef __x86_64__
BOOST_AUTO_TEST_CASE(builds_are_those_that_the_compiler_too_says_this_processor_runs) {
  __builtin_cpu_init();
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                  __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd");
  BOOST_CHECK_EQUAL(kernels().size(), 1u + v3 + v4);
}
#endif

BOOST_AUTO_TEST_CASE(unknown_build_is_refused_by_naming_those_there_are) {
  try {
    kernel("itanium");
    BOOST_ERROR("no error");
  } catch (const InputError& e) {
    const std::string text = e.what();
    for (const std::string word : {"itanium", "auto", kernels().front()->name})
      BOOST_CHECK_MESSAGE(text.find(word) != std::string::npos, text);
  }
}

BOOST_AUTO_TEST_CASE(products_are_those_of_eigen) {
  for (const Kernel* k : kernels())
    for (const int n : kSizes) {
      const Mat6X J = random_matrix(6, n, 1);
      const VecX v = random_matrix(n, 1, 2);
      Vec6 out = random_matrix(6, 1, 3);
      const Vec6 expected = out - J * v;
      k->subtract_product(n, J.data(), v.data(), out.data());
      BOOST_CHECK_SMALL((out - expected).cwiseAbs().maxCoeff(), kRounding);

      const RowMatX A = random_matrix(n, n, 4);
      const RowMatX S = A + A.transpose();
      const Rows4 X = random_matrix(n, 4, 5);
      Rows4 Y = Rows4::Zero(n, 4);
      k->multiply(n, S.data(), Sparsity(n).spans(), X.data(), Y.data());
      BOOST_CHECK_SMALL((Y - S * X).cwiseAbs().maxCoeff(), 100 * kRounding);
    }
}

BOOST_AUTO_TEST_CASE(product_with_the_inertia_of_a_tree_is_the_whole_product) {
  std::mt19937 random(6);
  for (const Kernel* k : kernels())
    for (const int n : kSizes) {
      // A random tree; an entry is zero where neither coordinate is before the other on the way to the root.
      std::vector<int> parent(n);
      for (int i = 0; i < n; ++i) parent[i] = static_cast<int>(random() % (i + 1)) - 1;
      const auto moves = [&](int i, int j) {
        while (j > i) j = parent[j];
        return i == j;
      };
      RowMatX S = random_matrix(n, n, 4);
      S = (S + S.transpose()).eval();
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          if (!moves(i, j) && !moves(j, i)) S(i, j) = 0.0;
      const Rows4 X = random_matrix(n, 4, 5);
      Rows4 sparse = Rows4::Zero(n, 4), whole = Rows4::Zero(n, 4);
      k->multiply(n, S.data(), Sparsity::of_tree(parent).spans(), X.data(), sparse.data());
      k->multiply(n, S.data(), Sparsity(n).spans(), X.data(), whole.data());
      BOOST_CHECK(sparse == whole);
    }
}

BOOST_AUTO_TEST_CASE(joint_torque_is_its_formula) {
  for (const Kernel* k : kernels())
    for (const int n : kSizes) {
      const Rows4 w = random_matrix(n, 4, 1);
      const Eigen::Vector4d at = random_matrix(4, 1, 2);
      const Mat6X J_left = random_matrix(6, n, 3), J_right = random_matrix(6, n, 4);
      const Vec6 f_left = random_matrix(6, 1, 5), f_right = random_matrix(6, 1, 6);
      VecX tau(n);
      k->joint_torque(n, w.data(), at.data(), J_left.data(), f_left.data(), J_right.data(), f_right.data(), tau.data());
      const VecX expected = w * at + J_left.transpose() * f_left + J_right.transpose() * f_right;
      BOOST_CHECK_SMALL((tau - expected).cwiseAbs().maxCoeff(), kRounding);
    }
}

BOOST_AUTO_TEST_CASE(leg_is_solved_whatever_the_order_of_its_rows) {
  for (const Kernel* k : kernels())
    for (unsigned seed = 0; seed < 50; ++seed) {
      Mat6 M = random_matrix(6, 6, seed);
      if (seed % 2) M(0, 0) = M(1, 1) = 0.0;  // asks for pivots
      const Eigen::Matrix<double, 6, 4> R = random_matrix(6, 4, 1000 + seed);
      System system = system_of(M, R);
      const double pivot = k->solve_leg(system.data());
      const Eigen::PartialPivLU<Mat6> lu(M);
      BOOST_CHECK_CLOSE(pivot, lu.matrixLU().diagonal().cwiseAbs().minCoeff(), 1e-6);
      BOOST_CHECK_SMALL((M * system.rightCols<4>() - R).cwiseAbs().maxCoeff(), 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(singular_leg_shows_in_its_pivot) {
  for (const Kernel* k : kernels()) {
    Mat6 M = random_matrix(6, 6, 7);
    M.row(5) = M.row(2);
    System system = system_of(M, Eigen::Matrix<double, 6, 4>::Ones());
    BOOST_CHECK_LT(k->solve_leg(system.data()), kRounding);
    system.setZero();
    BOOST_CHECK_EQUAL(k->solve_leg(system.data()), 0.0);
    system = system_of(M, Eigen::Matrix<double, 6, 4>::Ones());
    system(3, 3) = kNaN;
    BOOST_CHECK(!(k->solve_leg(system.data()) > 0.01));
  }
}
