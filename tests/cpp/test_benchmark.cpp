#include <boost/test/unit_test.hpp>

#include "testing.hpp"
#include "walk.hpp"
#include "zmpwalk/benchmark.hpp"
#include "zmpwalk/math/error.hpp"

using namespace zmpwalk;
using namespace zmpwalk::testing;

namespace {

const std::vector<double>& column(const std::vector<Column>& columns, const std::string& name) {
  for (const Column& c : columns)
    if (c.name == name) return c.values;
  throw std::runtime_error("no column " + name);
}

}  // namespace

BOOST_AUTO_TEST_CASE(fast_path_is_the_textbook_over_a_walk_with_all_phases) {
  CycleBenchmark benchmark(mahru(), describe(mahru()), WalkSettings(), VelocityProfile::paper());
  const std::vector<Column> columns = benchmark.run(4.0, 5);
  const auto &phase = column(columns, "phase"), &difference = column(columns, "difference");
  BOOST_REQUIRE_EQUAL(phase.size(), 4000);
  int compared[2] = {0, 0};
  for (std::size_t k = 0; k < phase.size(); ++k) {
    if (std::isnan(difference[k])) continue;
    ++compared[static_cast<int>(phase[k])];
    BOOST_CHECK_LT(difference[k], 1e-9);
  }
  BOOST_CHECK_GT(compared[0], 100);
  BOOST_CHECK_GT(compared[1], 400);
}

BOOST_AUTO_TEST_CASE(cycle_on_mujocos_terms_has_the_bits_of_the_one_from_scratch) {
  WalkingController computed(mahru(), describe(mahru())), given(mahru(), describe(mahru()));
  const MjDataPtr d = make_data(mahru());
  computed.robot().description().place(mahru(), d.get());
  computed.reset(d.get());
  given.reset(d.get());
  while (d->time < 2.0) {
    const VecX tau = computed.update(d.get()).tau;
    mj_step1(mahru(), d.get());
    const CycleOutput& out = given.update(d.get(), Terms::kInData);
    BOOST_REQUIRE(out.tau == tau);
    BOOST_REQUIRE(out.zmp_est == computed.output().zmp_est);
    mj_step2(mahru(), d.get());
  }
}

BOOST_AUTO_TEST_CASE(terms_of_another_state_are_refused_and_nothing_changes) {
  WalkingController controller(mahru(), describe(mahru()));
  const MjDataPtr d = make_data(mahru());
  controller.robot().description().place(mahru(), d.get());
  controller.reset(d.get());
  controller.update(d.get());
  mj_step(mahru(), d.get());  // the terms are those of the state before it
  const VecX ctrl = Eigen::Map<const VecX>(d->ctrl, mahru()->nu);
  BOOST_CHECK_THROW(controller.update(d.get(), Terms::kInData), InputError);
  BOOST_CHECK((Eigen::Map<const VecX>(d->ctrl, mahru()->nu) == ctrl));
  mj_step1(mahru(), d.get());
  BOOST_CHECK_NO_THROW(controller.update(d.get(), Terms::kInData));
}

BOOST_AUTO_TEST_CASE(builds_of_the_loops_walk_alike) {
  // Rounding differs, and a walk amplifies it; so the same states are put to every build.
  for (const Kernel* k : kernels()) {
    WalkingController plain(mahru(), describe(mahru()),
                            with([](WalkSettings& s) { s.control.kernel = kernels()[0]->name; }));
    WalkingController other(mahru(), describe(mahru()), with([&](WalkSettings& s) { s.control.kernel = k->name; }));
    const MjDataPtr d = make_data(mahru());
    plain.robot().description().place(mahru(), d.get());
    plain.reset(d.get());
    other.reset(d.get());
    while (d->time < 2.0) {
      const VecX tau = other.update(d.get()).tau;
      const VecX expected = plain.update(d.get()).tau;
      BOOST_REQUIRE_SMALL((tau - expected).norm() / expected.norm(), 1e-9);
      mj_step(mahru(), d.get());
    }
  }
}

BOOST_AUTO_TEST_CASE(runge_kutta_walks_in_whole_steps_and_is_not_timed) {
  const ModelPtr m = load_text(replaced(mahru_text(), "integrator=\"Euler\"", "integrator=\"RK4\""));
  BOOST_CHECK_THROW(CycleBenchmark(m.get(), describe(m.get()), WalkSettings(), VelocityProfile::paper()), InputError);
  const Walk walk(1.0, WalkSettings(), VelocityProfile::paper(), m.get());
  BOOST_CHECK(walk.result.fell == Fall::kNone);
  BOOST_CHECK_EQUAL(walk.rows(), 1000);
}
