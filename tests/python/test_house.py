"""The rooms of the Python package: each imports only those below it, and one alone knows how a file is replaced."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest
import zmpwalk

PACKAGE = Path(zmpwalk.__file__).parent

# From the ground up: a module imports modules of floors below its own, or of its own where that makes no circle.
FLOORS = [
    ["errors", "_build", "_columns", "_core"],
    ["files", "checks"],
    ["functions", "analysis", "settings"],
    ["_adapters", "profiles", "motion", "given", "robots", "disturbances"],
    ["_check_mujoco", "tasks", "terrain", "verdict"],
    ["shortfalls"],
    ["trace"],
    ["simulation"],
    ["waypoints", "bench", "render", "capture", "trials", "tryout", "sweeps", "exports"],
    ["live"],
    ["view", "figures", "gym", "pushes"],
    ["plot", "troubles"],
    ["shown", "explorer"],
    ["cli"],
    ["", "__main__"],  # the package's own __init__, which knows all rooms
]
# What may be imported in a function: packages that are slow, optional or not there yet; and the rooms that draw, by
# those who draw only when asked to.
DEFERRED = {
    "concurrent", "difflib", "glfw", "html", "imageio", "importlib", "mujoco", "mujoco_menagerie", "pandas", "rich",
    "tomli", "tomlkit", "tomllib",
}  # fmt: skip
DEFERRED_ROOMS = {
    "": {"_adapters"},
    "_check_mujoco": {"_build", "_core"},
    "cli.inspect": {"figures.robot"},
    "cli.plot": {"plot"},
    "cli.walk": {"plot"},
    "robots.load": {"robots.mjcf", "robots.urdf"},
    "robots.source": {"robots.source_files"},
    "shown": {"figures", "figures.small"},
}


def modules():
    """{dotted name inside the package: file} of every module; '' is the package itself."""
    found = {}
    for path in PACKAGE.rglob("*.py"):
        parts = list(path.relative_to(PACKAGE).with_suffix("").parts)
        if parts[-1] == "__init__":
            parts.pop()
        found[".".join(parts)] = path
    return found


MODULES = {**modules(), "_core": PACKAGE / "_core.pyi"}  # the extension, by its stubs


def imports_in(tree, name):
    """Names of the package's modules, and of others' packages, that are imported anywhere under a syntax tree.

    Those in functions and those for types alone count as all others do.
    """
    is_package = MODULES[name].name == "__init__.py"
    parents = [part for part in name.split(".") if part]
    parents = parents if is_package else parents[:-1]
    rooms, others = set(), set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            others |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and not node.level:
            others.add(node.module.split(".")[0])
        elif isinstance(node, ast.ImportFrom):
            base = parents[: len(parents) - node.level + 1] + (node.module.split(".") if node.module else [])
            for alias in node.names:
                inner = ".".join([*base, alias.name])
                rooms.add(inner if inner in MODULES else ".".join(base))
    return rooms, others


def tree_of(name):
    return ast.parse(MODULES[name].read_text(encoding="utf-8"))


GRAPH = {name: imports_in(tree_of(name), name)[0] for name in MODULES}


def floor_of(name):
    room = name.split(".")[0]
    return next(i for i, rooms in enumerate(FLOORS) if room in rooms)


def test_every_module_has_its_floor():
    rooms = {name.split(".")[0] for name in MODULES}
    assert rooms == {room for rooms in FLOORS for room in rooms}


def test_no_module_leads_back_to_itself():
    done, open_ = set(), []

    def visit(name):
        assert name not in open_, f"import circle: {' -> '.join([*open_[open_.index(name) :], name])}"
        if name in done:
            return
        open_.append(name)
        for other in sorted(GRAPH[name]):
            visit(other)
        open_.pop()
        done.add(name)

    for name in sorted(GRAPH):
        visit(name)


@pytest.mark.parametrize("name", sorted(MODULES))
def test_a_room_imports_only_rooms_below_it(name):
    room = name.split(".")[0]
    for other in GRAPH[name]:
        assert other.split(".")[0] == room or floor_of(other) < floor_of(name), f"{name} imports {other}"


def test_nobody_names_the_package_where_a_dot_does():
    for name in MODULES:
        assert "zmpwalk" not in imports_in(tree_of(name), name)[1], name


def test_only_what_is_slow_is_imported_in_functions():
    for name in MODULES:
        for function in ast.walk(tree_of(name)):
            if isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
                rooms, others = imports_in(function, name)
                assert others <= DEFERRED, f"{name}.{function.name} imports {others - DEFERRED}"
                assert rooms <= DEFERRED_ROOMS.get(name, set()), f"{name}.{function.name} imports {rooms}"


@pytest.mark.parametrize("name", sorted(set(MODULES) - {"files"}))
def test_files_are_replaced_in_one_room(name):
    for node in ast.walk(tree_of(name)):
        if isinstance(node, ast.Attribute):
            owner = node.value.id if isinstance(node.value, ast.Name) else ""
            assert (owner, node.attr) not in (("os", "replace"), ("shutil", "move")), f"line {node.lineno}"
            assert node.attr not in ("rename", "renames"), f"line {node.lineno}"


def loaded_by(room):
    """Names of all modules that importing `room` loads beside mujoco and numpy."""
    code = f"import sys, mujoco, numpy; before = set(sys.modules); import {room}; print(*(set(sys.modules) - before))"
    return set(subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.PIPE).stdout.decode().split())


def test_the_import_loads_nothing_slow_that_most_scripts_do_not_use():
    loaded = loaded_by("zmpwalk")
    slow = {
        "matplotlib", "rich", "click", "pandas", "imageio", "gymnasium", "distributed", "pyarrow", "cloudpickle",
        "glfw", "IPython", "jsonschema", "xml", "html", "email", "difflib", "tomli", "tomllib", "concurrent", "asyncio",
        "multiprocessing",
    }  # fmt: skip
    assert not slow & {name.split(".")[0] for name in loaded}
    assert "importlib.metadata" not in loaded
    ours = {name for name in loaded if name.startswith("zmpwalk.")}
    rooms = {name.split(".")[1] for name in ours}
    assert not rooms & set(zmpwalk._LATER), "these are imported when somebody asks for one of their names"


def test_every_public_name_is_there_when_asked_for():
    assert set(zmpwalk.__all__) >= {name for names in zmpwalk._LATER.values() for name in names}
    for name in zmpwalk.__all__:
        assert getattr(zmpwalk, name) is not None
    with pytest.raises(AttributeError, match="no attribute 'no_such_name'"):
        _ = zmpwalk.no_such_name


@pytest.mark.parametrize("room", ["zmpwalk", "zmpwalk.cli", "zmpwalk.view"])
def test_nothing_but_figures_loads_matplotlib(room):
    code = f"import sys, {room}; sys.exit('matplotlib' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
