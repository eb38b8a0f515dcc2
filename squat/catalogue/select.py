"""Rows and columns of the table of runs."""

import difflib
import re
from collections.abc import Sequence
from typing import Any

import pandas as pd

from squat.catalogue.find import FIXED, RESULT
from squat.errors import InputError

_CALLS = ("isin", "isna", "notna", "between", "abs", "contains", "startswith", "endswith")
"""Methods of columns that a condition may call: none that writes, reads or runs anything."""
_GRAMMAR = ("and", "or", "not", "in", "True", "False", "None")
_QUOTED = re.compile(r"""'[^']*'|"[^"]*"|`[^`]*`""")
_ASSIGNED = re.compile(r"(?<![=<>!])=(?!=)")
OWN_NAMES = (".name", ".shape")
"""Ends of the keys by which a node of a configuration names itself."""
_BARE = re.compile(r"\b((?:kind|status)\s*[=!]=\s*)([^\W\d]\w*)")
"""A kind or a status compared with a word that is not quoted; it may be a column's name."""
_LISTED = 12
"""Names of columns that a message has room for."""
_WORD = re.compile(r"""'[^']*'|"[^"]*"|`[^`]*`|[^\W\d][\w.]*""")


def listed(names: str | Sequence[str]) -> tuple[str, ...]:
    """`names`, or the one name that is given in place of them."""
    return tuple(filter(None, [names])) if isinstance(names, str) else tuple(names)


def select(frame: pd.DataFrame, where: str = "", sort: str | Sequence[str] = ()) -> pd.DataFrame:
    """Rows of `frame` that satisfy `where`, sorted by the columns `sort` (``-name``: descending).

    Without `sort` they are sorted by the configured numbers that vary, kind by kind.

    Raises
    ------
    InputError
        `where` cannot be read, or names what no run has.
    """
    if where:
        _harmless(where)
        try:
            frame = frame[_met(where, frame)]
        except Exception as error:  # pandas raises a dozen types for what a user may mistype
            raise InputError(f"where={where}: {_complaint(where, frame, error)}") from None
    sort = listed(sort)
    names = [name.removeprefix("-") for name in sort]
    _known(names, frame, "sort")
    if not names:
        frame = frame.loc[_by_numbers(frame)]
    else:
        ascending = [not name.startswith("-") for name in sort]
        frame = frame.sort_values(names, ascending=ascending, kind="stable")
    return frame.reset_index(drop=True)


def _met(where: str, frame: pd.DataFrame) -> "pd.Series[bool]":
    """Which rows satisfy `where`; those that have nothing to compare do not."""
    met = pd.Series(frame.eval(_quoted(where, frame), engine="python"), frame.index)
    if pd.api.types.infer_dtype(met, skipna=True) != "boolean":
        raise ValueError("a value, no condition")
    return met.fillna(False).astype(bool)


def _by_numbers(frame: pd.DataFrame) -> pd.Index:
    numbers = [
        name
        for name in varying(frame)
        if not name.startswith(RESULT) and pd.api.types.is_numeric_dtype(frame[name])
    ]
    keys = frame[["kind", *numbers]].assign(kind=pd.factorize(frame["kind"])[0])
    return keys.sort_values(["kind", *numbers], kind="stable").index


def columns(frame: pd.DataFrame, names: Sequence[str]) -> pd.DataFrame:
    """The columns `names`, or where none are given those that tell the runs apart.

    What follows from a choice (`coupling`) is left out then. A run alone has nobody to differ
    from: its headline figures are shown.
    """
    _known(names, frame, "columns")
    alone = [
        name for name in frame.columns if name.startswith(RESULT) and frame[name].notna().all()
    ]
    return frame[list(names) or [*FIXED, *(independent(frame) if len(frame) > 1 else alone)]]


def varying(frame: pd.DataFrame) -> list[str]:
    """Columns beside the fixed ones that do not have one value in all rows.

    A choice that older files do not tell is not another one.
    """
    groups = [name for name in parts(frame) if "." not in name]

    def values(name: str) -> "pd.Series[Any]":
        return (frame[name].dropna() if name in groups else frame[name]).drop_duplicates()

    return [str(name) for name in frame.columns if name not in FIXED and len(values(name)) > 1]


def independent(frame: pd.DataFrame) -> list[str]:
    """What varies, but for the parts of a choice that it implies."""
    names = varying(frame)
    implied = {
        name
        for choice, prefix in parts(frame).items()
        for name in names
        if choice in names
        and choice != name
        and name.startswith(prefix)
        and implies(frame, choice, name)
    }
    return [name for name in names if name not in implied]


def parts(frame: pd.DataFrame) -> dict[str, str]:
    """What the parts of a choice begin with, by the columns that name one.

    Such are a group of `conf/` (`hull`), and what a node says of itself (`coupling.name`).
    """
    names = [str(name) for name in frame.columns]
    groups = {name.partition(".")[0] for name in names if "." in name}
    found = {name: f"{name}." for name in names if name in groups}
    own = {name: name.rpartition(".")[0] + "." for name in names if name.endswith(OWN_NAMES)}
    return {**found, **own}


def implies(frame: pd.DataFrame, one: str, other: str) -> bool:
    """Whether in `frame` the value of `one` tells that of `other`."""
    return len(frame[[one, other]].drop_duplicates()) == frame[one].nunique(dropna=False)


def _complaint(where: str, frame: pd.DataFrame, error: Exception) -> str:
    if _ASSIGNED.search(_QUOTED.sub("''", where)):
        return "= compares nothing; give =="
    names = [str(name) for name in frame.columns]
    for word in _WORD.findall(where):
        asked = word.strip("`")
        owner, _, method = asked.rpartition(".")
        called = method in _CALLS and owner.removesuffix(".str") in names
        known = called or asked in names
        if not (known or word.startswith(("'", '"')) or word in _GRAMMAR):
            return _unknown(asked, names)
    reason = str(error).splitlines()[0]
    return f"{reason}; give a condition like 'status == \"diverged\"' on columns of the table"


def _unknown(asked: str, names: Sequence[str]) -> str:
    """What to say of a column that there is not: those of its group, or the first of all."""
    near = meant(asked, names)
    hint = f"; did you mean {near}?" if near else ""
    group = asked.partition(".")[0]
    listed = [name for name in names if name.startswith(f"{group}.")] or list(names)
    rest = ", ...; the file of squat task=catalogue has all" if len(listed) > _LISTED else ""
    return (
        f"{asked} is no column{hint} (text is quoted, as in 'status == \"diverged\"'); "
        f"give one of {', '.join(listed[:_LISTED])}{rest}"
    )


def meant(asked: str, names: Sequence[str]) -> str:
    """The one of `names` that `asked` comes next to; empty: none."""
    choice = [name for name in names if name in (f"{asked}.name", f"{asked}.shape")]
    near = choice or difflib.get_close_matches(asked, names, n=1, cutoff=0.8)
    return near[0] if near else ""


def _quoted(where: str, frame: pd.DataFrame) -> str:
    """`where` with dotted names in the backticks that pandas asks for."""

    def quote(found: re.Match[str]) -> str:
        word = found[0]
        return f"`{word}`" if "." in word and word in frame.columns else word

    return _WORD.sub(quote, where)


def _harmless(where: str) -> None:
    """Refuse what would make of a condition a program, or hold a word for a column."""
    bare = _QUOTED.sub("''", where)
    called = [name for name in re.findall(r"(\w+)\s*\(", bare) if name not in _GRAMMAR]
    if found := _BARE.search(bare):
        raise InputError(f"where={where}: text is quoted; give {found[1]}'{found[2]}'")
    if "@" in bare or "__" in bare or set(called) - set(_CALLS):
        raise InputError(
            f"where={where}: only columns, values, comparisons and {', '.join(_CALLS)} are read"
        )


def _known(names: Sequence[str], frame: pd.DataFrame, key: str) -> None:
    for name in names:
        if name not in frame.columns:
            near = ", ".join(str(column) for column in frame.columns if name in str(column))
            remedy = f"give {near}" if near else "columns=[] shows what varies"
            raise InputError(f"{key}={name}: no run has it; {remedy}")
