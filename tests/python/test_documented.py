"""Every public name of the Python package says what it is: modules, functions, classes, methods and properties."""

import importlib
import inspect
import pkgutil

import zmpwalk

# Plain values that the extension shows without a word of their own.
OF_THE_EXTENSION = {
    "Dynamics.joints", "Dynamics.nv", "Robot.joint_names", "RobotDescription.left", "RobotDescription.name",
    "RobotDescription.right", "RobotDescription.stand_keyframe", "WalkSettings", "WalkSettings.lateral_feedback",
}  # fmt: skip
OPTIONAL = {"zmpwalk.gym": "gymnasium"}  # module: the package that it needs


def public_modules():
    """Every module that a user may import by name; an underscore or `cli` says that it is not for that."""
    yield zmpwalk
    for found in pkgutil.walk_packages(zmpwalk.__path__, "zmpwalk."):
        private = any(part.startswith("_") for part in found.name.split(".")[1:])
        if private or ".cli" in found.name:
            continue
        needed = OPTIONAL.get(found.name)
        if needed is None or importlib.util.find_spec(needed):
            yield importlib.import_module(found.name)


def members(kind):
    """What a class of ours defines itself and shows: name -> value."""
    return {name: value for name, value in vars(kind).items() if not name.startswith("_")}


def is_said(value):
    return bool((inspect.getdoc(value) or "").strip())


def undocumented():
    """Names without a word, each with its module and class."""
    for module in public_modules():
        if not is_said(module):
            yield module.__name__
        for name in getattr(module, "__all__", ()):
            value = getattr(module, name)
            if not (inspect.isclass(value) or inspect.isroutine(value)):
                continue  # modules are looked at by themselves; constants and kinds are explained where they are set
            if not is_said(value):
                yield f"{module.__name__}.{name}"
            if inspect.isclass(value) and value.__module__.startswith("zmpwalk"):
                fields = getattr(value, "_fields", ()) or getattr(value, "__dataclass_fields__", ())
                for member, what in members(value).items():
                    is_code = callable(what) or isinstance(what, (property, classmethod, staticmethod))
                    if is_code and member not in fields and not is_said(what):
                        yield f"{module.__name__}.{name}.{member}"


def test_no_public_name_is_undocumented():
    found = {name for name in undocumented() if not any(name.endswith("." + known) for known in OF_THE_EXTENSION)}
    assert sorted(found) == []
