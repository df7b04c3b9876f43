"""Results as Markdown: `python benchmarks/report.py RESULT.json [docs/benchmarks.md]` prints, or fills the page.

RESULT.json is what `zmpwalk bench --json` or `benchmarks/peers/run.py` wrote.
"""

import json
import re
import sys
from pathlib import Path

INEQUALITIES = "honours friction, CoP and unilateral inequalities, which our closed form does not"
MODES = {"ss": "in single support", "ds": "in double support", "stand": "standing still"}
WHO = {
    "zmpwalk_cpp": ("zmpwalk, whole cycle from the state alone, C++", None),
    "tsid_cpp": ("TSID, tick, C++", "zmpwalk_cpp"),
    "zmpwalk_python": ("zmpwalk, `controller.update(data)`, Python", None),
    "tsid_python": ("TSID, tick, Python", "zmpwalk_python"),
    "placo_python": ("placo, dynamics solver, Python", "zmpwalk_python"),
    "zmpwalk_cpp_in_loop": ("zmpwalk, the same after `mj_step1`, C++", None),
    "mj_step_cpp": ("the physics step of the same walk, C++", None),
}


def peers_table(result):
    """The comparison with TSID and placo as Markdown.

    Args:
        result: what `benchmarks/peers/run.py` writes as JSON.

    Returns:
        A table of minimum and median [us] with the ratio to our own cycle in the same language, each ratio beside what
        the peer does that we do not; then what was measured, on what, and how far the answers are apart.
    """
    cpu = result["cpu"]
    lines = [
        f"| {cpu}; µs, minimum / median | " + " | ".join(MODES.values()) + " | |",
        "|---|" + "---:|" * len(MODES) + "---|",
    ]
    for who, (label, ours) in WHO.items():
        cells = []
        for mode in MODES:
            time = result[mode].get(who)
            cell = f"{time['min']:.1f} / {time['median']:.1f}" if time else "–"
            # Standing still is double support to us: our cycle does the same there.
            reference = result["ds" if mode == "stand" else mode].get(ours)
            if time and reference:
                ratios = " / ".join(f"{time[k] / reference[k]:.1f} ×" for k in ("min", "median"))
                cell += f" (**{ratios}**)"
            cells.append(cell)
        lines.append(f"| {label} | " + " | ".join(cells) + f" | {'× ours; ' + INEQUALITIES if ours else ''} |")
    versions, agreement = result["versions"], result["agreement"]
    worst = {
        key: max(agreement[who][mode][key] for who in ("tsid_cpp", "tsid_python", "placo_python") for mode in MODES)
        for key in ("acceleration", "zmp_mm", "torque_motion", "torque")
    }
    size = result["size"]
    lines += [
        "",
        f"{cpu}, Python {result['python']} (peers: {result['peers_python']}), {result['compiler']}, our kernel "
        f"{result['kernel']}, the peers' packages as they come (generic x86-64), "
        + ", ".join(f"{name} {version}" for name, version in versions.items())
        + f". {result['rounds']} rounds in turn, {result['ticks']} ticks of each peer per round and mode, over "
        f"{result['states']['ss']} instants of single and {result['states']['ds']} of double support of one walk. "
        "A tick is: state in, terms of the rigid bodies, problem, solution, torque and acceleration out. Ours holds "
        "the gait, the estimate and the ZMP iteration besides, and is timed inside the walk, with the physics step "
        "between; the peers are timed one tick after the other.",
        "",
        f"TSID solves {size['ss']['variables']} unknowns under {size['ss']['equalities']} equalities and "
        f"{size['ss']['inequalities']} two-sided inequalities in single support, {size['ds']['variables']}, "
        f"{size['ds']['equalities']} and {size['ds']['inequalities']} in double support. Of these are active: "
        + ", ".join(
            f"{' to '.join(map(str, sorted({min(n), max(n)})))} {MODES[m]}" for m, n in result["active"].items()
        )
        + "; a foot with little load has its CoP on the edge.",
        "",
        "The robot is one: inertia, nonlinear effects, COM and sole positions of the exported URDF differ from "
        f"MuJoCo's by {max(agreement['model'].values()):.0e} at most (relative). The answers are one, too: to the same "
        f"commanded accelerations, the motion differs by {worst['acceleration']:.0e} m/s² or rad/s², the ZMP of the "
        f"contact wrenches by {worst['zmp_mm']:.0e} mm, the torque by {worst['torque_motion']:.0e} N m apart from how "
        f"two feet press against each other, which each chooses for itself (up to {worst['torque']:.0f} N m).",
    ]
    plans = result["plan"]["placo_python"]
    lines += [
        "",
        "Planning (footsteps, COM and ZMP), placo's walk generator from Python: "
        + "; ".join(
            f"{plan['min'] / 1e3:.1f} / {plan['median'] / 1e3:.1f} ms for {plan['planned_s']:.1f} s at {n} time steps "
            "per single support"
            for n, plan in plans.items()
        )
        + f" ({cpu}).",
    ]
    return "\n".join(lines)


def bench_tables(result):
    """The figures of `zmpwalk bench` as Markdown.

    Args:
        result: what `zmpwalk bench --json FILE` writes.

    Returns:
        Its tables, then what was measured on what.
    """
    from zmpwalk.bench import tables

    machine, build = result["machine"], result["build"]
    parts = []
    for title, headings, rows in tables(result):
        lines = [f"**{title}** ({machine['cpu']})", ""] if any(headings) else []
        lines += ["| " + " | ".join(headings) + " |", "|---|" + "---:|" * (len(headings) - 1)]
        lines += ["| " + " | ".join(row) + " |" for row in rows]
        parts.append("\n".join(lines))
    parts.append(
        f"{machine['cpu']}, {machine['cores']} cores, MuJoCo {machine['mujoco']}, Python {machine['python']}, NumPy "
        f"{machine['numpy']}, {build['compiler']}, kernel {build['kernel']}; {result['cycle']['cycles']} cycles, all "
        "on one core. Torque, contact wrench and ZMP of the fast path differ from the equations as printed by "
        f"{result['cycle']['largest_difference_to_textbook']:.0e} at most (relative), in every cycle compared."
    )
    return "\n\n".join(parts)


def fill(page, name, text):
    """`page` with what stands between `<!-- name -->` and `<!-- /name -->` replaced by `text`.

    Raises:
        ValueError: the page has no such place.
    """
    filled, count = re.subn(
        rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)",
        lambda m: f"{m.group(1)}\n{text}\n\n{m.group(2)}",
        page,
        flags=re.S,
    )
    if count != 1:
        raise ValueError(f"the page needs one '<!-- {name} -->' ... '<!-- /{name} -->', it has {count}")
    return filled


def main(arguments):
    result = json.loads(Path(arguments[0]).read_text())
    name, text = ("bench", bench_tables(result)) if "machine" in result else ("peers", peers_table(result))
    if len(arguments) == 1:
        print(text)
        return
    page = Path(arguments[1])
    page.write_text(fill(page.read_text(encoding="utf-8"), name, text), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    main(sys.argv[1:])
