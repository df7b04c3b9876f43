"""What mypy has to say of a trace's columns; `make lint` runs it. An ignore that is not needed is an error here."""

import numpy as np
from zmpwalk import Trace


def known_columns_are_arrays(trace: Trace) -> np.ndarray:
    speed: np.ndarray = trace.dcom[:, 0]
    return speed + trace.t + trace["com"][:, 0]


def a_misspelt_column_is_an_error(trace: Trace) -> list:
    return [
        trace.cmo,  # type: ignore[attr-defined]
        trace.zmp,  # type: ignore[attr-defined]
    ]
