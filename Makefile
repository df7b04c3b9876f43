# Everything that zmpwalk needs comes from the package index into build/; the system gives a C++17 compiler, GNU make,
# and a Python with its headers and venv. `make help` lists the targets.

SHELL := bash
.DEFAULT_GOAL := help
.NOTPARALLEL:
# No built-in rule: one would compile a program cpp/src/simulation, because a folder has that name.
MAKEFLAGS += --no-print-directory --no-builtin-rules

PYTHON ?=
PYTEST_ARGS ?=
CTEST_ARGS ?=
DEMO_OUT ?= out/demo
SANITIZE ?= address,undefined
JOBS ?= $(shell nproc 2>/dev/null || echo 2)

.PHONY: help demo test pytest ctest sanitize sanitize-extension sanitize-threads fuzz kills bench ladder pushes soak instructions same native peers smoke wheel wheels wheels-arm arm-check wheel-check adapters matrix refusals sdist stubs columns docs format lint check-all clean

help:
	@echo 'make demo         walk the paper'\''s experiment; figures, trace and summary go to $(DEMO_OUT)'
	@echo 'make test         pytest and ctest            (PYTEST_ARGS="-k zmp", CTEST_ARGS="-R pendulum")'
	@echo 'make pytest       only the Python tests;  make ctest  only the C++ tests'
	@echo 'make sanitize     the C++ tests under $(SANITIZE)'
	@echo 'make sanitize-extension  a quick part of the Python tests with the extension under address,undefined'
	@echo 'make sanitize-threads    commands, motions and walks from several threads under the thread sanitizer'
	@echo 'make fuzz         hostile inputs at every door;  FUZZ_ARGS="--seed 1 --inputs 100000 --only npz"'
	@echo 'make kills        kills commands at random moments and looks at what is there;  KILLS_ARGS="--count 60"'
	@echo 'make bench        how fast it is here: every figure of docs/benchmarks.md; make peers  beside TSID and placo'
	@echo 'make soak         an hour of random commands and pushes (docs/pushes.md);  SOAK_ARGS="--hours 0.1"'
	@echo 'make ladder       walks faster and faster until it falls (docs/walk_anywhere.md)'
	@echo 'make pushes       pushes the bundled robot until it falls (docs/pushes.md); an hour'
	@echo 'make instructions instructions of a cycle against the record (needs valgrind);  make native  against -march=native'
	@echo 'make same         whether the working tree walks bit for bit as BASE does (BASE=HEAD~3; without it, HEAD)'
	@echo 'make wheel        dist/*.whl;  make wheel-check  install it into an empty environment and walk;  make sdist'
	@echo 'make wheels       dist/*.whl for every Python that is here, with the adapters to every MuJoCo;  make wheels-arm  for aarch64'
	@echo 'make matrix       installs these wheels beside eight MuJoCo versions and walks (docs/mujoco.md)'
	@echo 'make refusals     errors from C++ on the wheel, and every MuJoCo that does not fit, each in one line'
	@echo 'make arm-check    the C++ tests and a walk of the aarch64 wheel under emulation (needs Debian, qemu-user-static)'
	@echo 'make adapters     layouts, adapters and attributes of every MuJoCo release anew (docs/mujoco.md)'
	@echo 'make smoke        the tests that depend on MuJoCo, under versions between the two of make test'
	@echo 'make format       clang-format, ruff, gersemi, nbstripout;  make lint  the same as a check, and mypy'
	@echo 'make stubs        python/zmpwalk/_core.pyi from the built module, and `make columns`'
	@echo 'make columns      docs/columns.md and python/zmpwalk/_columns.py from the table of recorded columns'
	@echo 'make docs         the site of docs/ into build/site; warnings are errors, and it needs no network'
	@echo 'make check-all    test on every Python there is (3.8 to 3.13), sanitize, lint, wheel-check'
	@echo 'make clean        remove build/ and dist/'
	@echo
	@echo 'PYTHON=3.11, python3.11 or a path chooses the interpreter, and with it MuJoCo: 2.2.2 up to Python 3.10, 4.0.0'
	@echo 'from 3.11 on. Without it: the highest of 3.10, 3.9, 3.8 that works, else python3. JOBS=n limits the compilers.'

clean:
	rm -rf build dist

# ---- which Python, which compiler: found once, only for the targets that need them
ifneq ($(filter-out help clean check-all,$(or $(MAKECMDGOALS),help)),)

INTERPRETER := $(shell .ci/find-python $(PYTHON))
ifeq ($(INTERPRETER),)
$(error no usable Python, see the line above)
endif
VERSION := $(shell '$(INTERPRETER)' -c 'import sys; print("%d.%d" % sys.version_info[:2])')
MARKER := $(shell '$(INTERPRETER)' -c 'import sys; print("<" if sys.version_info < (3, 11) else ">=")')
MUJOCO := $(shell sed -n 's/.*mujoco==\([0-9.]*\); python_version $(MARKER) .*/\1/p' pyproject.toml | head -n 1)

# CXX from the command line or the environment, else what CMake would take
COMPILER := $(if $(filter default undefined,$(origin CXX)),,$(CXX))
COMPILER := $(shell for c in $(or $(COMPILER),c++ g++ clang++); do \
	echo 'int main() { if constexpr (sizeof(int) > 1) return 0; }' | $$c -std=c++17 -fsyntax-only -x c++ - 2>/dev/null && \
	echo $$c && break; done)
ifeq ($(COMPILER),)
$(error zmpwalk: no C++17 compiler works$(if $(filter default undefined,$(origin CXX)),, as CXX=$(CXX)): install one (Debian, Ubuntu: apt install g++))
endif
export CXX := $(COMPILER)
ifneq ($(ZMPWALK_SAID),$(VERSION))
$(info zmpwalk: Python $(VERSION) ($(INTERPRETER)), MuJoCo $(MUJOCO), compiler $(CXX))
endif
export ZMPWALK_SAID := $(VERSION)
AGAIN = $(MAKE) -s PYTHON='$(INTERPRETER)'

B := build/py$(VERSION)
VENV := $(CURDIR)/$(B)/venv
PY := $(VENV)/bin/python
# --no-input and no version check: nothing here may wait for a person
PIP = $(PY) -m pip --disable-pip-version-check --no-input -q
# what a quiet step has to say is shown when it fails
QUIETLY = >$(B)/$(1).log 2>&1 || { cat $(B)/$(1).log >&2; exit 1; }
export PATH := $(VENV)/bin:$(PATH)
export CMAKE_BUILD_PARALLEL_LEVEL := $(JOBS)
unexport PYTHONPATH PYTHONHOME

SOURCES := pyproject.toml CMakeLists.txt $(shell find cmake cpp bindings python -type f \
	-not -path '*/__pycache__/*' -not -path '*/.*' 2>/dev/null) $(shell find cpp bindings python -type d 2>/dev/null)

# ---- environment, in layers, each behind a stamp
# The environment is made anew when the interpreter or the place of this folder changes.
IDENTITY := $(INTERPRETER) $(CURDIR)
ifneq ($(shell cat $(B)/identity 2>/dev/null),$(IDENTITY))
$(shell rm -rf $(B) && mkdir -p $(B) && echo '$(IDENTITY)' >$(B)/identity)
endif

$(B)/venv.stamp: $(B)/identity
	@echo '-- making $(B)/venv'
	@'$(INTERPRETER)' -m venv --clear $(VENV) || { echo "zmpwalk: $(INTERPRETER) -m venv failed \
	(Debian, Ubuntu: apt install python$(VERSION)-venv)" >&2; exit 1; }
	@$(PIP) install --upgrade pip $(call QUIETLY,pip) # the pip that an old Python brings resolves slowly
	@touch $@

define install_requirements
@echo '-- installing what pyproject.toml asks for: $(1)'
@$(PY) .ci/requirements.py $(1) >$@.txt
@$(PIP) install -r $@.txt $(call QUIETLY,requirements)
@touch $@
endef

$(B)/base.stamp: $(B)/venv.stamp pyproject.toml
	$(call install_requirements,reference build)

$(B)/test.stamp: $(B)/base.stamp
	$(call install_requirements,reference test)

$(B)/dev.stamp: $(B)/test.stamp
	$(call install_requirements,reference test lint)

# Two cores serve every Python here: that of the package, and that of the C++ tests with heap watch and assertions on.
core = .ci/core $(1) $(VENV) $(2)
core_file = $(CURDIR)/build/core/$(1)/libzmpwalk_core.a

# Not editable: the tests meet what a user gets, so that a file missing from the package fails here. The build folder is
# kept, so that only what changed is compiled.
$(B)/installed.stamp: $(B)/base.stamp $(SOURCES)
	@echo '-- building and installing zmpwalk'
	@$(call core,release) $(call QUIETLY,core)
	@$(PIP) install --no-build-isolation --no-deps --force-reinstall --config-settings=build-dir=$(B)/extension \
		--config-settings=cmake.define.ZMPWALK_CORE=$(call core_file,release) . $(call QUIETLY,install)
	@touch $@

# ---- demo
demo: $(B)/installed.stamp
	MPLBACKEND=Agg $(VENV)/bin/zmpwalk walk --profile paper --out $(DEMO_OUT)

# ---- tests: both runners always run; the last lines are their own totals
test:
	@$(AGAIN) pytest; pytest=$$?; $(AGAIN) ctest; ctest=$$?; \
	echo; echo '== Python $(VERSION), MuJoCo $(MUJOCO)'; \
	if [ $$ctest != 0 ]; then echo 'ctest failed'; fi; if [ $$pytest != 0 ]; then echo 'pytest failed'; fi; \
	grep -E 'tests passed.* out of' $(B)/ctest.log || tail -n 1 $(B)/ctest.log; tail -n 1 $(B)/pytest.log; \
	exit $$((pytest || ctest))

pytest:
	@echo 'pytest did not start' >$(B)/pytest.log
	@$(AGAIN) $(B)/test.stamp $(B)/installed.stamp
	@set -o pipefail; MPLBACKEND=Agg $(PY) -m pytest $(PYTEST_ARGS) 2>&1 | tee $(B)/pytest.log

# The installed core meets other MuJoCo versions: each is unpacked into a folder of its own and gets its adapter.
SMOKE := 2.3.7 3.1.6 3.3.7 3.8.1 3.17.0
smoke: $(B)/test.stamp $(B)/installed.stamp
	@MPLBACKEND=Agg $(PY) packaging/smoke.py $(B)/smoke $(SMOKE)

# The tests meet a core with heap watch and assertions on, and the same MuJoCo.
configure_tests = cmake -S . -B $(B)/$(1) -G Ninja -DPython_EXECUTABLE=$(PY) -DZMPWALK_BUILD_PYTHON=OFF \
	-DZMPWALK_BUILD_TESTS=ON -DZMPWALK_WERROR=$(WERROR) $(2) $(call QUIETLY,configure-$(1))
run_ctest = cd $(B)/$(1) && ctest --output-on-failure --no-tests=error --timeout $(2) -j $(JOBS) $(CTEST_ARGS)
WERROR ?= ON

ctest:
	@echo 'ctest did not start' >$(B)/ctest.log
	@$(AGAIN) $(B)/test.stamp
	@echo '-- building the C++ tests'
	@$(call core,tests,-DZMPWALK_BUILD_TESTS=ON -DZMPWALK_WERROR=$(WERROR))
	@$(call configure_tests,cpp,-DZMPWALK_CORE=$(call core_file,tests))
	@cmake --build $(B)/cpp
	@set -o pipefail; ($(call run_ctest,cpp,600)) 2>&1 | tee $(B)/ctest.log

sanitize: $(B)/test.stamp
	@echo '-- C++ tests under $(SANITIZE)'
	@$(call configure_tests,sanitize,-DZMPWALK_SANITIZE=$(SANITIZE))
	@cmake --build $(B)/sanitize
	@$(call run_ctest,sanitize,3000)

# The extension too, with the quick part of the tests that calls most of it. libasan has to be there before Python.
SANITIZED_TESTS ?= tests/python/test_identities.py tests/python/test_state.py tests/python/test_ingredients.py tests/python/test_settings.py
sanitize-extension: $(B)/test.stamp
	@echo '-- the extension under address,undefined'
	@cmake -S . -B $(B)/sanitize-extension -G Ninja -DPython_EXECUTABLE=$(PY) -DZMPWALK_SANITIZE=address,undefined -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
		-Dpybind11_DIR=$$($(PY) -m pybind11 --cmakedir) $(call QUIETLY,configure-sanitize-extension)
	@cmake --build $(B)/sanitize-extension
	@rm -rf $(B)/sanitized && mkdir -p $(B)/sanitized && cp -r python/zmpwalk $(B)/sanitized/
	@cp $(B)/sanitize-extension/_core*.so $(B)/sanitize-extension/_build.py $(B)/sanitized/zmpwalk/
	@mkdir -p $(B)/sanitized/zmpwalk/adapters && cp $(B)/sanitize-extension/adapter-*.so $(B)/sanitized/zmpwalk/adapters/
	@LD_PRELOAD="$$($(CXX) -print-file-name=libasan.so) $$($(CXX) -print-file-name=libstdc++.so)" ASAN_OPTIONS=detect_leaks=0 \
		PYTHONPATH=$(CURDIR)/$(B)/sanitized MPLBACKEND=Agg $(PY) -m pytest -q -p no:cacheprovider $(SANITIZED_TESTS)

sanitize-threads: $(B)/test.stamp
	@echo '-- walks, commands and motions from several threads under thread'
	@$(call configure_tests,threads,-DZMPWALK_SANITIZE=thread -DCMAKE_CXX_FLAGS_RELEASE=-O1)
	@cmake --build $(B)/threads --target test_threads
	@cd $(B)/threads && ctest --output-on-failure --no-tests=error --timeout 600 -R '^threads$$'

# ---- speed
FUZZ_ARGS ?= --inputs 5000
fuzz: $(B)/test.stamp $(B)/installed.stamp
	@MPLBACKEND=Agg $(PY) benchmarks/fuzz.py $(FUZZ_ARGS)

kills: $(B)/test.stamp $(B)/installed.stamp
	@MPLBACKEND=Agg $(PY) benchmarks/kills.py $(KILLS_ARGS)

BENCH_OUT ?= out/bench
UPDATE ?=
bench: $(B)/installed.stamp
	@mkdir -p $(BENCH_OUT)
	$(VENV)/bin/zmpwalk bench --json $(BENCH_OUT)/bench.json

ladder: $(B)/installed.stamp
	$(PY) benchmarks/walk_anywhere.py --only ladder

pushes: $(B)/installed.stamp
	$(PY) benchmarks/pushes.py

soak: $(B)/installed.stamp
	@$(PY) benchmarks/soak.py $(SOAK_ARGS)

peers: $(B)/installed.stamp
	$(PY) benchmarks/peers/run.py

configure_cycle = cmake -S . -B $(B)/$(1) -G Ninja -DPython_EXECUTABLE=$(PY) -DZMPWALK_BUILD_PYTHON=OFF \
	-DZMPWALK_BUILD_BENCHMARKS=ON $(2) $(call QUIETLY,configure-$(1))

instructions: $(B)/base.stamp
	@$(call configure_cycle,cycle)
	@cmake --build $(B)/cycle $(call QUIETLY,cycle)
	@$(PY) benchmarks/instructions.py $(B)/cycle/cycle "$$(cat $(B)/cycle/compiler)" $(UPDATE)

BASE ?= HEAD
same: $(B)/base.stamp
	@$(PY) benchmarks/same_walk.py $(BASE)

native: $(B)/base.stamp
	@$(call configure_cycle,cycle)
	@cmake --build $(B)/cycle $(call QUIETLY,cycle)
	@$(call configure_cycle,cycle-native,-DZMPWALK_NATIVE=ON)
	@cmake --build $(B)/cycle-native $(call QUIETLY,cycle-native)
	@$(PY) benchmarks/native.py $(B)/cycle/cycle $(B)/cycle-native/cycle

# ---- packages
wheel: $(B)/base.stamp
	@rm -rf $(B)/wheel
	@$(PIP) wheel --no-deps --wheel-dir $(B)/wheel . $(call QUIETLY,wheel)
	@mkdir -p dist && cp $(B)/wheel/*.whl dist/ && ls $(B)/wheel/*.whl | sed 's,.*/,dist/,'

# Wheels for every Python that is here, with all adapters, for old Linux systems.
wheels: $(B)/venv.stamp
	@$(PY) packaging/wheels.py $(WHEELS_ARGS)

wheels-arm: $(B)/venv.stamp
	@$(PY) packaging/wheels.py --target aarch64 --python 3.11 $(WHEELS_ARGS)

matrix: wheels
	@$(PY) packaging/matrix.py dist/*$$(uname -m).whl $(MATRIX_ARGS)

# The oldest and the newest of the MuJoCo versions, each with a Python that has it.
refusals: wheels
	@$(PY) packaging/refusals.py dist/*cp310*$$(uname -m).whl 2.2.2
	@$(PY) packaging/refusals.py dist/*cp312*$$(uname -m).whl 4.0.0

arm-check: wheels-arm
	@$(PY) packaging/wheels.py --python 3.11
	@$(PY) packaging/arm.py dist/*cp311*.whl $(ARM_ARGS)

adapters: $(B)/venv.stamp
	@$(PY) cpp/adapter/layouts.py build/mujoco --adapters build/adapters
	@$(PY) cpp/adapter/attributes.py build/mujoco

wheel-check: wheel
	@if $(PY) -m zipfile -l $(B)/wheel/*.whl | grep libmujoco; then echo 'the wheel holds libmujoco' >&2; exit 1; fi
	@'$(INTERPRETER)' -m venv --clear $(B)/empty
	@$(B)/empty/bin/python -m pip --disable-pip-version-check -q install "$$(ls $(B)/wheel/*.whl)[reference]" $(call QUIETLY,wheel-check)
	@cd $(B) && MPLBACKEND=Agg empty/bin/zmpwalk walk --duration 2 --out wheel-check
	@echo 'the wheel walks in an empty environment'

sdist: $(B)/base.stamp
	@$(PY) -c 'from scikit_build_core.build import build_sdist; print("dist/" + build_sdist("dist"))'

# ---- style
CXX_FILES = $(shell find cpp bindings tests/cpp -name '*.hpp' -o -name '*.cpp')
CMAKE_FILES = CMakeLists.txt tests/cpp/CMakeLists.txt cmake/Wheels.cmake
NOTEBOOKS = $(wildcard notebooks/*.ipynb)
GERSEMI = gersemi --indent 2 --line-length 120 --no-warn-about-unknown-commands

format: $(B)/dev.stamp
	clang-format -i $(CXX_FILES)
	ruff check --fix -q .; ruff format -q .
	if [ -x $(VENV)/bin/gersemi ]; then $(GERSEMI) -i $(CMAKE_FILES); fi
	$(if $(NOTEBOOKS),nbstripout $(NOTEBOOKS))

lint: $(B)/dev.stamp $(B)/installed.stamp
	clang-format --dry-run -Werror $(CXX_FILES)
	ruff check . && ruff format --check .
	if [ -x $(VENV)/bin/gersemi ]; then $(GERSEMI) --check $(CMAKE_FILES); fi
	$(if $(NOTEBOOKS),nbstripout --verify $(NOTEBOOKS))
	mypy

columns: $(B)/installed.stamp
	$(PY) docs/make_columns.py

docs: $(B)/test.stamp $(B)/installed.stamp
	$(PY) -m sphinx -q -W --keep-going -b html docs build/site
	@echo 'the site is build/site/index.html'

stubs: $(B)/dev.stamp $(B)/installed.stamp columns
	cd $(B) && $(VENV)/bin/pybind11-stubgen zmpwalk._core -o stubs >/dev/null
	$(PY) bindings/stubs.py $(B)/stubs/zmpwalk/_core.pyi
	cp $(B)/stubs/zmpwalk/_core.pyi python/zmpwalk/_core.pyi
	ruff format -q python/zmpwalk/_core.pyi

endif

# ---- everything, everywhere
check-all:
	@export ZMPWALK_BIG=1; failed=; for version in 3.8 3.9 3.10 3.11 3.12 3.13; do \
		if .ci/find-python $$version >/dev/null 2>&1; then \
			$(MAKE) test PYTHON=$$version && $(MAKE) wheel-check PYTHON=$$version || failed="$$failed $$version"; \
		else echo "zmpwalk: no Python $$version here, not checked"; fi; done; \
	for what in sanitize sanitize-extension sanitize-threads; do $(MAKE) $$what || failed="$$failed $$what"; done; \
	$(MAKE) lint || failed="$$failed lint"; \
	if [ -n "$$failed" ]; then echo "failed:$$failed" >&2; exit 1; fi; echo 'all checks passed'
