"""The stability map: who is safe, how closely, and how soon the others ground."""

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from squat.figures.style import single

_LIFTED, _UNDECIDED = 2, 3


def stability_map(data: xr.Dataset) -> Figure:
    """Least clearance of the safe, time to grounding of the others, and the separatrix."""
    figure, axes = single(8.0, 5.2)
    V, w, outcome = data["current"].values, data["initial_heave"].values, data["outcome"]
    clearance = data["least_clearance"].where(outcome == 0)
    seconds = data["time_to_grounding"]
    safe = axes.pcolormesh(V, w, clearance, cmap="cividis", shading="nearest", rasterized=True)
    lost = axes.pcolormesh(
        V,
        w,
        seconds,
        cmap="OrRd_r",
        shading="nearest",
        rasterized=True,
        vmax=float(seconds.quantile(0.98)),
    )
    edge = data["edge_current"].values
    turn = data["edge_turn"].where(data["edge_turn"] < w[-1]).values
    loop = np.r_[data["edge_barrier"].values, turn[::-1]]
    known = np.isfinite(loop)
    line = axes.plot(np.r_[edge, edge[::-1]][known], loop[known], "k", lw=1.6, label="separatrix")
    handles: list[Artist] = [*line]
    for code, color, label in (
        (_LIFTED, "0.8", "rises beyond the model"),
        (_UNDECIDED, "k", "undecided"),
    ):
        here = (outcome == code).values
        if here.any():
            axes.contourf(V, w, here, [0.5, 1.5], colors=[color])
            handles.append(Patch(color=color, label=label))
    figure.colorbar(lost, ax=axes, label="grounded: time to grounding [s]", extend="max")
    figure.colorbar(safe, ax=axes, label="safe: least under-keel clearance [m]")
    axes.set(xlim=(V[0], V[-1]), ylim=(w[0], w[-1]))
    axes.grid(visible=False)
    axes.set_xlabel("current relative to the ship $V_\\infty$ [m/s]")
    axes.set_ylabel("initial heave $w(0)$, released at rest [m]")
    figure.legend(handles=handles, loc="outside upper center", ncols=3)
    return figure
