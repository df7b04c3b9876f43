"""Drawing of figures: a module for each family of figures, and modules for what they share.

Every drawing function takes a trace and returns a matplotlib Figure; `zmpwalk.plot` knows them all by name. Nothing
here touches pyplot, so no window opens and no global state is left behind.

Colours mean the same in every figure: black the centre of mass, blue what is desired, red what the controller
estimates, green what the simulator measures, orange what is planned; light blue lines are ZMP bounds, grey bars below
are double support, brown bands soles on the ground (from above the right one is purple). Only where traces are compared
the colours tell them apart.
"""

__all__ = ["FILES", "FORMATS"]

FORMATS = ("png", "pdf", "svg")

FILES = {  # the figures by name, and what their files are called without the suffix
    "estimate": "estimate",
    "iteration": "fig2_iteration",
    "tracking": "fig4_tracking",
    "switch": "fig5_switch",
    "velocity": "fig6_velocity",
    "sagittal": "fig7_sagittal",
    "lateral": "fig8_lateral",
    "footprints": "footprints",
}
