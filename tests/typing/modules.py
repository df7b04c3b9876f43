"""What mypy has to say of the modules that are imported late; an ignore that is not needed is an error here."""

import zmpwalk
from zmpwalk import Trace


def known_functions(trace: Trace) -> None:
    zmpwalk.plot.compare({"a": trace})
    zmpwalk.render.snapshot(trace)


def a_function_that_is_not_there_is_an_error(trace: Trace) -> None:
    zmpwalk.plot.foo(trace)  # type: ignore[attr-defined]
    zmpwalk.render.vidoe(trace)  # type: ignore[attr-defined]
