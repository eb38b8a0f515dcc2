"""The table of docs/licences.md, every locked dependency: `python -m workflows.licences`."""

import re
from importlib.metadata import Distribution, PackageNotFoundError, distribution, requires
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
WINDOWS = {"colorama": "BSD-3-Clause", "pyreadline3": "BSD-3-Clause"}
"""Installed on Windows alone, so read from their repositories."""
ARM_S_LENGTH = {"gmsh", "docutils"}
"""Not permissive as a whole; the page says why that is no obstacle."""
PERMISSIVE = re.compile(
    r"\b(MIT|BSD|0BSD|ISC|Apache|PSF|Python Software Foundation|HPND|Unlicense|Zlib|CNRI|Boost|"
    r"MPL|Mozilla|LGPL|CC0)\b",
    re.IGNORECASE,
)
COPYLEFT = re.compile(r"\bA?GPL|GNU (Affero )?General Public", re.IGNORECASE)
PAGE = ROOT / "docs" / "licences.md"
_HEAD = "| package | licence | use |\n|---|---|---|\n"


class Entry(NamedTuple):
    """One dependency: name, licence as its metadata has it, and what it is for."""

    name: str
    licence: str
    use: str


def locked() -> list[str]:
    """Names in requirements.lock."""
    text = (ROOT / "requirements.lock").read_text("utf-8")
    return sorted(set(re.findall(r"^([A-Za-z0-9_.-]+)==", text, re.MULTILINE)))


def licence(name: str) -> str:
    """Licence by SPDX expression, classifier, field, or file, whichever is first there."""
    if name in WINDOWS:
        return WINDOWS[name]
    try:
        found = distribution(name)
    except PackageNotFoundError:
        return "unknown: not installed"
    meta: Any = found.metadata
    kinds = [text.split(" :: ")[-1] for text in meta.get_all("Classifier") or []]
    named = [k for k, c in zip(kinds, meta.get_all("Classifier") or [], strict=True) if _is(c)]
    field = str(meta.get("License", "")).strip().splitlines()[:1]
    expression = str(meta.get("License-Expression", ""))
    short = field[0] if field and field[0] != "UNKNOWN" else ""
    return expression or ", ".join(named) or short or _first_line(found) or "unknown"


def _is(classifier: str) -> bool:
    return classifier.startswith("License ::") and classifier != "License :: OSI Approved"


def _first_line(found: Distribution) -> str:
    for file in found.files or []:
        if re.search(r"LICEN[CS]E", file.name, re.IGNORECASE):
            return Path(str(file.locate())).read_text("utf-8").strip().splitlines()[0]
    return ""


def entries() -> list[Entry]:
    """Every locked dependency."""
    own = {re.split(r"[^A-Za-z0-9_.-]", text)[0].lower() for text in requires("squat") or []}
    project = (ROOT / "pyproject.toml").read_text("utf-8")
    group = project.split("[dependency-groups]")[1].split("]\n")[0]
    tools = {name.lower() for name in re.findall(r'"([A-Za-z0-9_.-]+)', group)}

    def use(name: str) -> str:
        return "run" if name in own else "develop" if name in tools else "indirect"

    return [Entry(name, licence(name), use(name.lower())) for name in locked()]


def page() -> str:
    """docs/licences.md with its table made anew."""
    rows = [f"| {one.name} | {one.licence} | {one.use} |\n" for one in entries()]
    return PAGE.read_text("utf-8").split(_HEAD)[0] + _HEAD + "".join(rows)


def compatible(one: Entry) -> bool:
    """Whether its licence lets squat be distributed under MIT beside it."""
    if one.name in ARM_S_LENGTH:
        return True
    text = one.licence.replace("LGPL", "L-G-P-L")
    return bool(PERMISSIVE.search(one.licence)) and not COPYLEFT.search(text)


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
