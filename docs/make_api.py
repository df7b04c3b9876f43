"""Writes the page of the Python names from `zmpwalk.__all__`: `python docs/make_api.py`."""

import inspect
from pathlib import Path

import zmpwalk

HEAD = """# Python: every name

This page lists every public name of `import zmpwalk` with its docstring. `python docs/make_api.py` writes it.
"""


def page() -> str:
    """The page: functions, classes, then modules, each in the order of the alphabet."""
    parts: dict = {"Functions": [], "Classes": [], "Errors": [], "Modules": []}
    for name in zmpwalk.__all__:
        value = getattr(zmpwalk, name)
        if name.startswith("__"):
            continue
        if inspect.ismodule(value):
            parts["Modules"].append(("automodule", name, "members"))
        elif inspect.isclass(value):
            is_error = issubclass(value, Exception)
            parts["Errors" if is_error else "Classes"].append(("autoclass", name, "" if is_error else "members"))
        else:
            parts["Functions"].append(("autofunction", name, ""))
    text = HEAD
    for title, entries in parts.items():
        text += f"\n## {title}\n"
        for directive, name, option in entries:
            options = f"   :{option}:\n" if option else ""
            text += f"\n```{{eval-rst}}\n.. {directive}:: zmpwalk.{name}\n{options}```\n"
    return text


if __name__ == "__main__":
    (Path(__file__).parent / "api.md").write_text(page(), encoding="utf-8")
