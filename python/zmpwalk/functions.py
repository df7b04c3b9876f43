"""What tells one Python function from another: its code, and the values that the code reads."""

from __future__ import annotations

import dis
import functools
import hashlib
import json
from types import CodeType, FunctionType, MethodType
from typing import Any, Callable, Iterator, Mapping

import numpy as np

__all__ = ["fingerprint"]

ATOMS = (bool, int, float, complex, str, bytes, type(None), type(Ellipsis))


def fingerprint(function: Callable[..., Any]) -> str:
    """A text that changes where the function's code does; spaces, comments and docstrings do not count.

    It knows the bytecode with its constants, the defaults of arguments, and the numbers, texts, arrays and containers
    of these that the function reads from around it; and the same of the functions of its own module that it calls. Of
    a function of another module, and of any other object, it knows the name alone. It knows no file that is read.
    Another Python version has other bytecode.

    Args:
        function: a function, a method, a `functools.partial` or an object that is called.

    Returns:
        64 hexadecimal digits.

    Usage: `fingerprint(lambda trace: {"height": trace.com[:, 2].min()})`
    """
    words = _of(function, getattr(function, "__module__", None), set())
    return hashlib.sha256(json.dumps(words, sort_keys=True).encode()).hexdigest()


def _of(value: Any, home: str | None, seen: set[int]) -> Any:
    """Plain lists and texts that say what a value is; `home` is the module whose functions are looked into."""
    if isinstance(value, ATOMS):
        return repr(value)
    if isinstance(value, (np.ndarray, np.generic)) and value.dtype != object:
        array = np.ascontiguousarray(value)
        return ["array", str(array.dtype), list(array.shape), hashlib.sha256(array.tobytes()).hexdigest()]
    if id(value) in seen:
        return "the same as above"
    seen = seen | {id(value)}
    if isinstance(value, (list, tuple)):
        return [type(value).__name__, *(_of(item, home, seen) for item in value)]
    if isinstance(value, (set, frozenset)):
        return ["set", *sorted(json.dumps(_of(item, home, seen)) for item in value)]
    if isinstance(value, Mapping):
        return ["mapping", *([_of(key, home, seen), _of(item, home, seen)] for key, item in value.items())]
    if isinstance(value, functools.partial):
        return ["partial", *(_of(part, home, seen) for part in (value.func, value.args, value.keywords))]
    if isinstance(value, MethodType):
        return ["method", _of(value.__func__, home, seen), _of_object(value.__self__, home, seen)]
    if isinstance(value, FunctionType):
        return _of_function(value, home, seen) if value.__module__ == home else _name(value)
    if callable(value) and not isinstance(value, type) and type(value).__module__ == home:
        return ["called", _of(type(value).__call__, home, seen), _of_object(value, home, seen)]
    return _name(value)


def _of_object(value: Any, home: str | None, seen: set[int]) -> Any:
    return [_name(value), _of(vars(value), home, seen) if hasattr(value, "__dict__") else None]


def _of_function(function: FunctionType, home: str | None, seen: set[int]) -> Any:
    around = {name: function.__globals__[name] for name in _names(function.__code__) if name in function.__globals__}
    cells = [cell.cell_contents if _is_full(cell) else None for cell in function.__closure__ or ()]
    parts = (function.__defaults__, function.__kwdefaults__, cells, around)
    return ["function", _of_code(function.__code__), *(_of(part, home, seen) for part in parts)]


def _is_full(cell: Any) -> bool:
    try:
        cell.cell_contents  # noqa: B018
    except ValueError:  # the variable has no value yet
        return False
    return True


def _of_code(code: CodeType) -> Any:
    constants = [constant for k, constant in enumerate(code.co_consts) if not _is_docstring(code, k)]
    inner = [_of_code(item) if isinstance(item, CodeType) else _of(item, None, set()) for item in constants]
    return ["code", code.co_code.hex(), inner, list(code.co_names), list(code.co_varnames), list(code.co_freevars)]


def _is_docstring(code: CodeType, k: int) -> bool:
    """Whether the constant k is one: the first constant is, where it is a text that the bytecode never loads."""
    if k or not isinstance(code.co_consts[0], str):
        return False
    return not any(step.opname.startswith("LOAD_CONST") and step.arg == 0 for step in dis.get_instructions(code))


def _names(code: CodeType) -> Iterator[str]:
    """Names that a function and the functions in it read from its module, and attributes, in a fixed order."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _name(value: Any) -> str:
    kind = value if hasattr(value, "__qualname__") else type(value)
    return f"{getattr(kind, '__module__', '')}.{getattr(kind, '__qualname__', kind)}"
