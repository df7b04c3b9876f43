#include "zmpwalk/benchmark.hpp"

#include "common.hpp"

using namespace zmpwalk;

void bind_benchmark(py::module_& m) {
  m.def(
      "benchmark_cycle",
      [](const py::object& model, const RobotDescription& description, const WalkSettings& settings,
         const VelocityProfile& profile, double duration, int textbook_every, const py::object& on_progress) {
        CycleBenchmark benchmark(model_of(model), description, settings, profile);
        std::vector<Column> columns;
        PythonProgress progress(on_progress, duration);
        {
          py::gil_scoped_release unlocked;
          columns = benchmark.run(duration, textbook_every, std::ref(progress));
        }
        progress.rethrow();
        return take_columns(std::move(columns));
      },
      "model"_a, "description"_a, "settings"_a, "profile"_a, "duration"_a, "textbook_every"_a = 20,
      "on_progress"_a = py::none(),
      "Times the parts of a control cycle while a robot walks, all in the same cycles.\n\n"
      "Args:\n    duration: simulated time [s].\n    textbook_every: equations as printed are timed in each n-th "
      "cycle; 0 "
      "never.\n    on_progress: called as f(t, duration) about 20 times a second; may raise.\n\n"
      "Returns:\n    columns by name, (T,), times in microseconds: phase (0 double, 1 single support), in_loop, "
      "from_scratch, step,\n    terms, terms_from_scratch, algebra, iteration, other, textbook, difference (of "
      "textbook and "
      "algebra, relative).\n\nRaises:\n    ModelError, InputError as WalkingController; InputError for a Runge-Kutta "
      "integrator.");
  m.def(
      "benchmark_walk",
      [](const py::object& model, const RobotDescription& description, const WalkSettings& settings,
         const VelocityProfile& profile, double duration, const py::object& on_progress) {
        std::vector<Column> columns;
        PythonProgress progress(on_progress, duration);
        const mjModel* walked = model_of(model);
        {
          py::gil_scoped_release unlocked;
          columns = benchmark_walk(walked, description, settings, profile, duration, std::ref(progress));
        }
        progress.rethrow();
        return take_columns(std::move(columns));
      },
      "model"_a, "description"_a, "settings"_a, "profile"_a, "duration"_a, "on_progress"_a = py::none(),
      "Times a recorded walk and mj_step alone on the same states, piece by piece in turn.\n\n"
      "Args:\n    duration: simulated time [s].\n    on_progress: called as f(t, duration) about 10 times a second; "
      "may raise.\n\n"
      "Returns:\n    columns by name, (pieces,): walk, bare, microseconds per step; difference, the largest difference "
      "of qvel between\n    the two at the end of the piece, which is zero.\n\nRaises:\n    ModelError, InputError as "
      "WalkingController; InputError for a Runge-Kutta integrator.");
}
