"""How many random humanoids walk with the defaults alone: `python benchmarks/random_robots.py [--seeds 0:100]`.

Each robot of `random_humanoid` is bare: `zmpwalk` proposes its description. It walks 10 s at the Froude speed
v / sqrt(g z_c) = 0.06, reached from a stand in 3 s. Prints those that do not and what was measured over the others;
`--page docs/random_robots.md` writes that page's part for this MuJoCo, `--json FILE` every number.
"""

import argparse
import json
from pathlib import Path

import mujoco
import numpy as np
import random_humanoid as generator
import zmpwalk
from pages import write_blocks
from rich.console import Console
from rich.progress import track
from zmpwalk import analysis
from zmpwalk.robots import humanoid, propose

FROUDE, RAMP, DURATION = 0.06, 3.0, 10.0  # of the walk: speed, [s], [s]
REASONS = ("torque: ", "reach: ", "a usual walk", "the soles are meshes", "cannot hold", "refuses it")  # in remarks
GROUPS = (
    ("all that walk", lambda r: True),
    (
        "soles of boxes, spheres, capsules; never saturated",
        lambda r: r["facts"]["feet"] != "mesh" and not r["saturated"],
    ),
    ("the same, a torque saturated", lambda r: r["facts"]["feet"] != "mesh" and r["saturated"]),
    ("soles of meshes", lambda r: r["facts"]["feet"] == "mesh"),
)


def walk(seed, duration=DURATION):
    """One robot's walk.

    Returns:
        seed, facts (what was drawn), result ('walks', 'falls', 'refused'), why, t (how long it stood) [s], remarks (of
        its description); where it moved also v [m/s], torque (largest that the closed form asks for) and saturated
        (share of cycles in which that is beyond a limit) [%]; where it walked speed (error of the last steps) [%],
        median_mm and p95_mm (estimated ZMP against contact forces in single support, x and y).
    """
    xml, facts = generator.random_humanoid(seed)
    model = mujoco.MjModel.from_xml_string(xml)
    row = {"seed": seed, "facts": facts, "result": "refused", "why": "", "t": 0.0, "remarks": []}
    try:
        proposal = propose(model)
        row["remarks"] = proposal.remarks
        v = FROUDE * float(np.sqrt(humanoid.G * proposal.table["com_height_m"]))
        profile = zmpwalk.VelocityProfile.ramp(0.0, v, RAMP)
        trace = zmpwalk.simulate((model, proposal.description), profile, duration)
    except zmpwalk.Error as error:
        return {**row, "why": str(error)}
    summary, single = trace.summary(), analysis.zmp_error(trace, single_support=True)
    row.update(
        result="falls" if summary["fell"] else "walks", why=summary["fall_cause"] or "",
        t=summary["fall_time"] if summary["fell"] else duration, v=v,
        torque=100 * float(trace.torque_ratio.max()), saturated=100 * float(np.mean(trace.torque_ratio > 1.0)),
    )  # fmt: skip
    if not summary["fell"]:
        walked, planned = np.array(summary["mean_speed_per_step"]), np.array(summary["planned_speed_per_step"])
        row["speed"] = 100 * float(np.abs(walked - planned)[5:].max() / v)
        row["median_mm"] = (1e3 * np.median(single, axis=0)).tolist()
        row["p95_mm"] = (1e3 * np.percentile(single, 95, axis=0)).tolist()
    return row


def explanations(row):
    """What `zmpwalk inspect` says of a robot that may keep it from walking: a refusal, or remarks."""
    if row["result"] == "refused":
        return [row["why"]]
    return [remark for remark in row["remarks"] if any(reason in remark for reason in REASONS)]


def results(rows):
    """Lines of markdown: how many walk, those that do not, what the others measured."""
    walks = [r for r in rows if r["result"] == "walks"]
    seeds = f"{rows[0]['seed']} to {rows[-1]['seed']}"
    yield f"**MuJoCo {mujoco.__version__}: {len(walks)} of {len(rows)} walk** (seeds {seeds})."
    failed = [r for r in rows if r["result"] != "walks"]
    if failed:
        yield ""
        yield "| seed | result | what `zmpwalk inspect` says of it | leg, m | mass, kg | sole | armature/(mass leg²) |"
        yield "|---|---|---|---|---|---|---|"
    for r in failed:
        f, said = r["facts"], "; ".join(explanations(r)) or "nothing"
        result = "refused" if r["result"] == "refused" else f"falls at {r['t']:.1f} s: {r['why']}"
        cells = (r["seed"], result, said, f"{f['leg']:.2f}", f"{f['mass']:.1f}", f["feet"], f"{f['armature']:.3f}")
        yield "| " + " | ".join(map(str, cells)) + " |"
    yield ""
    yield "| of those that walk | robots | largest torque, % | speed error, % | single support median, mm | p95, mm |"
    yield "|---|---|---|---|---|---|"
    for name, belongs in GROUPS:
        some = [r for r in walks if belongs(r)]
        if not some:
            continue
        columns = [[max(np.atleast_1d(r[key])) for r in some] for key in ("torque", "speed", "median_mm", "p95_mm")]
        cells = [" / ".join(f"{q:.3g}" for q in np.quantile(column, (0.5, 0.9, 1.0))) for column in columns]
        yield f"| {name} | {len(some)} | " + " | ".join(cells) + " |"


def limits():
    """Lines of markdown: what the generator draws."""
    g, h = generator, humanoid

    def span(pair, factor=1):
        return f"{factor * pair[0]:g} to {factor * pair[1]:g}"

    links = [f"{link} {span(share)}" for link, share in g.LINK_MASS.items()]
    rows = [
        ("leg = thigh + shank", span(g.LEG) + " m"),
        ("thigh", span(g.THIGH) + " of the leg"),
        ("mass", f"{span(g.MASS)} times {h.DENSITY:g} kg/m³ leg³ (log)"),
        ("foot length", span(g.FOOT_LENGTH) + " of the leg"),
        ("foot width", f"{span(g.FOOT_WIDTH)} of the leg, at most {g.WIDEST:g} of the hips' distance"),
        ("ankle over the sole", f"{span(g.HEEL)} of the length from the heel, {span(g.ANKLE_SIDE)} of the width off"),
        ("ankle height; hips' distance", f"{span(g.ANKLE_HEIGHT)}; {span(g.HIP_DISTANCE)} of the leg"),
        ("between the hip's axes", f"none, or {span(g.HIP_OFFSET)} of the leg"),
        ("torso height", span(g.TORSO_HEIGHT) + " of the leg"),
        ("masses", ", ".join(links) + " of the robot's; the torso is what is left"),
        (
            "torque limit",
            f"each kind of joint {span(g.TORQUE)} times its static need in single support at the toe (log)",
        ),
        ("armature", f"none, or {span(g.ARMATURE)} mass leg² (log)"),
        ("damping", f"none, or {span(g.DAMPING)} mass g leg √(leg / g) (log)"),
        ("dry friction", f"none, or {span(g.FRICTION)} mass g leg (log)"),
        ("the last three in arms and neck", f"{h.ARM_SHARE:g} of that"),
        ("gear", f"1, or {span(g.GEAR)} (log)"),
        ("hip, ankle", f"{', '.join(g.HIPS)}; {', '.join(g.ANKLES)} (y yaw, r roll, p pitch; from the trunk down)"),
        ("base", "pelvis, or trunk (waist inside the legs' chain)"),
        ("waist, neck", f"{', '.join(w or 'none' for w in h.WAISTS)}; 0 to {len(h.NECK)} joints"),
        ("arms", f"none, or 2 to {len(h.ARM)} joints each"),
        ("links", "one hinge a body, or several; axes as named, or some turned round"),
        ("sole", ", ".join(h.FEET)),
        ("timestep; contact's solref", f"{', '.join(map(str, g.TIMESTEPS))}; {', '.join(map(str, g.SOLREFS))} s"),
    ]
    yield "| drawn | limits (uniform; log: log-uniform) |"
    yield "|---|---|"
    for name, value in rows:
        yield f"| {name} | {value} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", default="0:100", help="first:end, or numbers with commas (default 0:100)")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write every number there")
    parser.add_argument("--page", type=Path, metavar="FILE", help="update that page")
    args = parser.parse_args()
    first, colon, end = args.seeds.partition(":")
    seeds = list(range(int(first), int(end))) if colon else [int(seed) for seed in args.seeds.split(",")]
    rows = [walk(seed) for seed in track(seeds, description="walking", console=Console(stderr=True))]
    if args.json:
        args.json.write_text(json.dumps(rows, indent=1), encoding="utf-8")
    if args.page:
        write_blocks(args.page, {"limits": limits(), f"MuJoCo {mujoco.__version__[0]}": results(rows)})
    print("\n".join(results(rows)))


if __name__ == "__main__":
    main()
