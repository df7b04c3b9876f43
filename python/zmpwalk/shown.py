"""How values show themselves: in a terminal as one line, in a notebook as a table with a small picture.

`show_values` gives the classes of the package their `__repr__` and `_repr_html_`, also those that are written in C++.
"""

from __future__ import annotations

import base64
import math
from typing import Any, Callable, Iterable

import numpy as np

from ._core import RobotDescription, WalkSettings
from .profiles import VelocityProfile
from .simulation import WalkingController
from .trace import Trace

__all__ = ["settings_changes", "show_values"]

Cells = Iterable[Any]


def show_values() -> None:
    """Gives trace, profile, description, settings and controller the form in which they are printed and shown."""
    texts: dict[type, Callable[[Any], str]] = {RobotDescription: _description_text, WalkSettings: _settings_text}
    for kind, text in texts.items():
        setattr(kind, "__repr__", text)  # noqa: B010  an extension's class, which is no place for a plain assignment
    pages: dict[type, Callable[[Any], str]] = {
        Trace: _trace_html,
        VelocityProfile: _profile_html,
        RobotDescription: _description_html,
        WalkSettings: _settings_html,
        WalkingController: _controller_html,
    }
    for kind, page in pages.items():
        setattr(kind, "_repr_html_", page)  # noqa: B010


def settings_changes(settings: WalkSettings) -> dict[str, Any]:
    """What differs from the defaults of the settings' own law, by the settings' one-word names.

    Usage: `settings_changes(WalkSettings(tracker_gain=3.0))  # -> {"tracker_gain": 3.0}`
    """
    given, preset = settings.to_dict(), WalkSettings(law=settings.law).to_dict()
    return {name: value for name, value in given.items() if name != "law" and not _same(value, preset[name])}


def _same(a: Any, b: Any) -> bool:
    return bool(a == b) or (isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b))


# --- texts


def _description_text(description: RobotDescription) -> str:
    sole = f"{description.left.length:.3f} × {description.left.width:.3f} m"
    legs = len(description.left.leg_joints) + len(description.right.leg_joints)
    feet = f"'{description.left.body}', '{description.right.body}'"
    return f"RobotDescription({description.name or 'unnamed'}, feet {feet}, soles {sole}, {legs} leg joints)"


def _settings_text(settings: WalkSettings) -> str:
    changes = "".join(f", {name}={value!r}" for name, value in settings_changes(settings).items())
    return f"WalkSettings(law={settings.law!r}{changes})"


# --- pages


def _trace_html(trace: Trace) -> str:
    meta, rows = trace.meta, [["cycles", f"{len(trace.t)} of {1e3 * trace.control_dt:g} ms"]]
    fell = meta.get("fall_time")
    end = f"fell at {fell:.2f} s: {meta.get('fall_cause') or 'cause unknown'}" if fell is not None else "stood"
    rows.insert(0, ["walk", f"{trace.duration:g} s, {end}"])
    figure = None
    if len(trace.t) > 1 and {"com", "dcom", "zmp_est", "zmp_meas", "phase", "v_plan"} <= set(trace):
        said = trace.summary()
        forward = float(np.sum(trace.forward_velocity()) * trace.control_dt)
        error = said["zmp_error_mm"]
        rows += [
            ["went", f"{forward:.2f} m forward in {said['step_count']} steps"],
            ["|estimated − measured ZMP|", f"median {_pair(error['median'])} mm, 95 % below {_pair(error['p95'])} mm"],
            ["largest torque", _percent(said["peak_torque_ratio"])],
        ]
        rows += [["fell short", shortfall] for shortfall in said["shortfalls"]]
        figure = _picture("walked", trace)
    versions = meta.get("versions", {})
    rows.append(["made by", f"zmpwalk {versions.get('zmpwalk', '?')}, MuJoCo {versions.get('mujoco', '?')}"])
    return _page(f"Trace of {meta.get('robot', 'a robot')}", _table(rows), figure)


def _profile_html(profile: VelocityProfile) -> str:
    t, v = np.asarray(profile.t), np.asarray(profile.v)
    shown = range(len(t)) if len(t) <= 8 else [*range(4), None, *range(len(t) - 3, len(t))]
    rows: list[list[Any]] = [
        ["…"] * 4 if k is None else [f"{t[k]:g}", *(f"{value:.4g}" for value in v[k])] for k in shown
    ]
    head = ["from [s]", "forward [m/s]", "leftward [m/s]", "turning [rad/s]"]
    how = "each held until the next" if profile.interpolation == "hold" else "joined by lines"
    return _page(f"Velocity profile, {how}", _table(rows, head), _picture("profile", profile))


def _description_html(description: RobotDescription) -> str:
    rows = [["free joint", description.root_joint or "without a name"]]
    for side, foot in (("left", description.left), ("right", description.right)):
        size = f"sole {1e3 * foot.length:.0f} × {1e3 * foot.width:.0f} mm"
        rows.append([f"{side} foot", f"body {foot.body}, {size}"])
        rows.append([f"{side} leg", ", ".join(foot.leg_joints)])
    rows.append(["start pose", description.stand_keyframe or f"{len(description.stand_joints)} joint angles"])
    return _page(f"Robot description of {description.name or 'a robot'}", _table(rows))


def _settings_html(settings: WalkSettings) -> str:
    changes = settings_changes(settings)
    table = {row.flat: row for row in WalkSettings.table().values()}
    if not changes:
        return _page(f"Settings of the law “{settings.law}”", "<p>Every setting is the law's default.</p>")
    rows = [[name, value, table[name].unit, table[name].meaning] for name, value in changes.items()]
    page = _table(rows, ["setting", "value", "unit", "meaning"])
    return _page(f"Settings of the law “{settings.law}”, changed", page)


def _controller_html(controller: WalkingController) -> str:
    changes = settings_changes(controller.settings)
    rows = [
        ["robot", f"{len(controller.joint_names)} joints, {controller.mass:.2f} kg"],
        ["COM", f"{controller.com_height:.3f} m over the soles, T_c = {controller.Tc:.4f} s"],
        ["reaches", f"{controller.speed_limit:.2f} m/s forward"],
        ["law", controller.settings.law],
        ["settings in force", f"{len(changes)} that this robot or you decide; controller.settings has all"],
        ["cycles", str(controller.cycles)],
    ]
    return _page(
        f"Walking controller of {controller.description.name}",
        _table(rows),
        _picture("profile", controller.profile),
    )


def _page(title: str, *parts: str | None) -> str:
    from html import escape

    body = "".join(f"<div style='margin-right:1.5em'>{part}</div>" for part in parts if part)
    return f"<div><b>{escape(title)}</b><div style='display:flex;flex-wrap:wrap'>{body}</div></div>"


def _table(rows: Iterable[Cells], head: Cells = ()) -> str:
    from html import escape

    def line(cells: Cells, tag: str) -> str:
        style = " style='text-align:left;vertical-align:top'"
        return "<tr>" + "".join(f"<{tag}{style}>{escape(str(cell))}</{tag}>" for cell in cells) + "</tr>"

    top = line(head, "th") if list(head) else ""
    return f"<table>{top}{''.join(line(row, 'td') for row in rows)}</table>"


def _picture(kind: str, value: Any) -> str:
    """The small figure of that name, inside a page."""
    from .figures import small  # matplotlib is slow to import

    picture = small.png(getattr(small, kind)(value))
    return f"<img alt='' src='data:image/png;base64,{base64.b64encode(picture).decode()}'>"


def _pair(values: Iterable[float | None]) -> str:
    return " / ".join("–" if value is None else f"{value:.2g}" for value in values)


def _percent(share: float | None) -> str:
    return "–" if share is None else f"{100 * share:.0f} % of its limit"
