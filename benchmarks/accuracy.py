"""How far the estimated ZMP is from MuJoCo's contact forces: `python benchmarks/accuracy.py [--json]`.

The bundled robot under the default law: the paper's profile for 120 s, then 30 s with other contacts and other cycles.
"""

import argparse
import json

import numpy as np
import zmpwalk
from rich.console import Console
from rich.progress import track
from zmpwalk import analysis


def cases():
    """(label, model edit, settings, duration [s]) of each row."""

    def solref(seconds):
        return lambda model: model.geom_solref.__setitem__((slice(None), 0), seconds)

    def timestep(seconds):
        return lambda model: setattr(model.opt, "timestep", seconds)

    yield "as shipped: solref 0.005 s, cycle 1 ms", None, {}, 120.0
    for seconds in (0.002, 0.01, 0.02):
        yield f"solref {seconds} s", solref(seconds), {}, 30.0
    for seconds in (0.0005, 0.002, 0.004):
        yield f"cycle and physics {1e3 * seconds:g} ms", timestep(seconds), {}, 30.0
    for seconds in (0.002, 0.004):
        yield f"cycle {1e3 * seconds:g} ms, physics 1 ms", None, {"control_dt": seconds}, 30.0


def row(edit, settings, duration):
    """One walk's numbers, errors in mm."""
    model, description = zmpwalk.load_robot("mahru")
    if edit is not None:
        edit(model)
    trace = zmpwalk.simulate((model, description), duration=duration, settings=zmpwalk.WalkSettings(**settings))
    summary = trace.summary()
    planned, walked = np.array(summary["planned_speed_per_step"]), np.array(summary["mean_speed_per_step"])
    single = analysis.zmp_error(trace, single_support=True)
    return {
        "duration": duration,
        "steps": summary["step_count"],
        "fell": bool(summary["fell"]),
        "speed_error_percent": float(100 * np.abs(walked / planned - 1).max()),
        "median_mm": (1e3 * np.median(analysis.zmp_error(trace), axis=0)).tolist(),
        "single_support_p95_mm": (1e3 * np.percentile(single, 95, axis=0)).tolist(),
        "p95_mm": (1e3 * np.percentile(analysis.zmp_error(trace), 95, axis=0)).tolist(),
        "bound_excess_mm": float(1e3 * max(analysis.bound_excess(trace).max(), 0.0)),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    as_json = parser.parse_args().json
    rows = {
        label: row(*case) for label, *case in track(list(cases()), description="walking", console=Console(stderr=True))
    }
    if as_json:
        print(json.dumps(rows, indent=1))
        return
    print("| walk | s | stands | speed, worst % | median mm, x / y | single support p95 | p95 | beyond bounds, mm |")
    print("|---|---|---|---|---|---|---|---|")
    for label, r in rows.items():
        pairs = [f"{r[k][0]:.4f} / {r[k][1]:.4f}" for k in ("median_mm", "single_support_p95_mm", "p95_mm")]
        stands = "no" if r["fell"] else "yes"
        cells = [
            label,
            f"{r['duration']:g}",
            stands,
            f"{r['speed_error_percent']:.2f}",
            *pairs,
            f"{r['bound_excess_mm']:.2f}",
        ]
        print("| " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
