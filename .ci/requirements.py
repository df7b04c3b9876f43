"""Print what pyproject.toml asks for: build and run time, and the extras named; one requirement a line.

Used by the Makefile, which installs these once and the package itself, without build isolation, as often as it changes.
"""

import re
import sys
from pathlib import Path

try:
    import tomllib
except ImportError:  # before Python 3.11
    from pip._vendor import tomli as tomllib

project = tomllib.loads(Path(__file__).resolve().parents[1].joinpath("pyproject.toml").read_text(encoding="utf-8"))
extras = project["project"]["optional-dependencies"]


def expand(requirements: "list[str]") -> "list[str]":
    """Replace zmpwalk[a,b] by what these extras hold."""
    result = []
    for requirement in requirements:
        own = re.fullmatch(r"zmpwalk\[(.*)\]", requirement)
        if own:
            for extra in own.group(1).split(","):
                result += expand(extras[extra.strip()])
        else:
            result.append(requirement)
    return result


wanted = project["build-system"]["requires"] + project["project"]["dependencies"]
for name in sys.argv[1:]:
    wanted += extras[name]
print("\n".join(dict.fromkeys(expand(wanted))))
