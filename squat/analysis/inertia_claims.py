"""Sentences of sections 3.5 and 3.6 on added mass."""

import math

import numpy as np
import xarray as xr

from squat.analysis.claims import Finding, Sources, claim, holds
from squat.analysis.inertia_tables import PRINTED
from squat.analysis.tables import compare
from squat.analysis.verdict import DIFFERS, INCONSISTENT, NOT_RUN


def _wendel(sources: Sources) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """H/T, Wendel's value and ours at a/T = 1."""
    table = compare("table4", sources.table4).query("source == 'wendel_1956'")
    columns = (
        table[name].astype(float).to_numpy() for name in ("depth_over_draft", "paper", "here")
    )
    ratio, wendel, here = columns
    return ratio, wendel, here


@claim("very_good_agreement")
def _(sources: Sources) -> Finding:
    ratio, wendel, here = _wendel(sources)
    apart = np.abs(here / wendel - 1)
    worst = int(apart.argmax())
    here_text = (
        f"within {100 * np.sort(apart)[-2]:.1f} % of Wendel's, but {100 * apart[worst]:.1f} %"
    )
    note = "the paper's own values lie as far from Wendel's; his are estimates"
    return Finding(f"{here_text} at H/T = {ratio[worst]:g}", note, holds(bool(apart.max() < 0.03)))


@claim("underestimates")
def _(sources: Sources) -> Finding:
    ratio, wendel, here = _wendel(sources)
    finite = np.isfinite(ratio)
    below = here[finite] < wendel[finite]
    share = 1 - here[finite][below] / wendel[finite][below]
    note = (
        "exact values, so neither elements nor In and Out explain it; most where Wendel's is "
        "printed as 1, by which very good agreement fails too; deep water, where the paper prints "
        "two equal numbers, is above 0.75"
    )
    text = f"below Wendel's in {below.sum()} of {below.size} cells of finite depth"
    if below.any():
        text += f", by {share.min():.1%} to {share.max():.1%}"
    return Finding(text, note, holds(bool(below.all())))


@claim("highest")
def _(sources: Sources) -> Finding:
    main, _ = _table5(sources)
    top = main.isel(cell=int(np.argmax(main["inertia_coefficient"].values)))
    ratio, a = float(top["depth_over_draft"]), float(top["a_over_T"])
    found = f"{float(top['inertia_coefficient']):.6g} at H/T = {ratio:g}, a/T = {a:g}"
    at_corner = ratio == main["depth_over_draft"].min() and a == main["a_over_T"].max()
    corner = min(ratio for ratio, _ in PRINTED), max(a for _, a in PRINTED)
    if at_corner and (ratio, a) != corner:
        return Finding(found, "the cell at the corner of the printed table was not run", NOT_RUN)
    return Finding(found, "", holds(bool(at_corner)))


def _table5(sources: Sources) -> tuple[xr.Dataset, int]:
    """The printed cells of Table 5 that were run, and how many others are printed."""
    names = "reading", "depth_over_draft", "a_over_T"
    rows = zip(*(sources.table5[name].values for name in names), strict=True)
    run = [n for n, row in enumerate(rows) if row[0] == "depth" and row[1:] in PRINTED]
    return sources.table5.isel(cell=run), len(PRINTED) - len(run)


def _light(sources: Sources) -> tuple[int, int, int]:
    """Printed cells of Table 5 in which the added mass does not exceed the ship's, all, not run."""
    main, missing = _table5(sources)
    ratio = main["inertia_coefficient"] * math.pi * main["a_over_T"] / 2
    return int((ratio <= 1).sum()), main.sizes["cell"], missing


@claim("rarely_satisfied")
def _(sources: Sources) -> Finding:
    light, cells, missing = _light(sources)
    text = f"in {light} of {cells} cells of Table 5"
    if missing:
        return Finding(text, f"{missing} more were not run", NOT_RUN)
    return Finding(text, "all at a/T = 0.5", holds(light / cells < 0.2))


@claim("exceeds_mass")
def _(sources: Sources) -> Finding:
    light, cells, missing = _light(sources)
    note = "Table 5 itself contradicts it at a/T = 0.5: i below 2/(pi a/T)"
    verdict = INCONSISTENT if light else NOT_RUN if missing else DIFFERS
    return Finding(f"not in {light} of {cells} cells of Table 5", note, verdict)


@claim("ratio_above_one")
def _(sources: Sources) -> Finding:
    ratio = float(sources.table6["mass_ratio"])
    return Finding(f"m_add/m = {ratio:.8g}", "zero pressure, Eq. (23)", holds(ratio > 1))
