"""Which parameters a sweep varies, read from the configurations of its jobs."""

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from squat import records
from squat.records.identity import HOUSEKEEPING
from squat.sweeps.jobs import Job

_LABELS = ("name", "shape")
_ABSENT = "(none)"
Value = float | str


class Axis(NamedTuple):
    """One swept parameter.

    `name` is the dimension, `key` the dotted configuration key, `of` each job's value by its name.
    """

    name: str
    key: str
    values: list[Value]
    of: dict[str, Value]


def axes_of(jobs: Sequence[Job], reserved: set[str]) -> list[Axis]:
    """The fewest parameters that tell all `jobs` apart (each with a configuration), in file order.

    A choice such as `coupling=printed` counts as one parameter, not as all the keys that it sets.
    A key that follows from others is no axis of its own; what was given comes first. `reserved`
    names are not given to axes.
    """
    flat = {job.name: dict(_leaves(job.config or {})) for job in jobs}
    given = {key for job in jobs for key in _given(job)}
    keys = sorted(_keys(flat), key=lambda pair: pair[0] not in given)
    candidates = [*_choices(jobs), *keys]
    chosen: list[tuple[str, dict[str, Value]]] = []
    for key, of in candidates:
        if not _follows(of, [values for _, values in chosen]):
            chosen.append((key, of))
    order = {key: n for n, key in enumerate(_order(flat))}
    chosen.sort(key=lambda pair: min((order[k] for k in order if _within(k, pair[0])), default=0))
    names = _names([key for key, _ in chosen], reserved)
    return [_axis(names[key], key, of) for key, of in chosen]


def _axis(name: str, key: str, of: Mapping[str, Value]) -> Axis:
    """Numbers in ascending order, names in that of the jobs."""
    if all(isinstance(value, float) for value in of.values()):
        return Axis(name, key, sorted(set(of.values())), dict(of))
    texts: dict[str, Value] = {job: str(value) for job, value in of.items()}
    return Axis(name, key, list(dict.fromkeys(texts.values())), texts)


def _leaves(value: Any, path: str = "") -> Iterator[tuple[str, Value]]:
    if isinstance(value, Mapping) and value:
        for key, inner in value.items():
            if path or key not in (*HOUSEKEEPING, "task"):
                yield from _leaves(inner, f"{path}.{key}" if path else str(key))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path, float(value)
    else:
        yield path, value if isinstance(value, str) else json.dumps(value)


def _choices(jobs: Sequence[Job]) -> Iterator[tuple[str, dict[str, Value]]]:
    """Groups that every job chose from, on its command line or as its file says, with the names."""
    given = [_given(job) for job in jobs]
    for group in given[0] if given else ():
        key = group.rpartition("@")[2].strip("/").replace("/", ".")
        nodes = all(isinstance(_node(job.config, key), Mapping) for job in jobs)
        if nodes and all(group in words for words in given):
            yield key, {job.name: words[group] for job, words in zip(jobs, given, strict=True)}


def _given(job: Job) -> dict[str, str]:
    if job.overrides or job.dataset is None:
        return dict(part.lstrip("+~").partition("=")[::2] for part in job.overrides)
    return records.choices_of(job.dataset.attrs)


def _node(config: Any, key: str) -> Any:
    for part in key.split("."):
        config = config.get(part) if isinstance(config, Mapping) else None
    return config


def _order(flat: Mapping[str, Mapping[str, Value]]) -> list[str]:
    return list(dict.fromkeys(key for config in flat.values() for key in config))


def _keys(flat: Mapping[str, Mapping[str, Value]]) -> Iterator[tuple[str, dict[str, Value]]]:
    """Keys with more than one value: those that name a choice first, as the choice's own key."""
    keys = _order(flat)
    naming = [key for key in keys if "." in key and key.rpartition(".")[2] in _LABELS]
    naming.sort(key=lambda key: key.count("."))
    for key in [*naming, *(key for key in keys if key not in naming)]:
        of = {job: config.get(key, _ABSENT) for job, config in flat.items()}
        yield key.rpartition(".")[0] if key in naming else key, of


def _follows(of: Mapping[str, Value], chosen: Sequence[Mapping[str, Value]]) -> bool:
    """Whether the chosen parameters determine `of`; none does that for what is constant."""
    seen: dict[tuple[Value, ...], Value] = {}
    return all(seen.setdefault(tuple(c[job] for c in chosen), v) == v for job, v in of.items())


def _within(key: str, node: str) -> bool:
    return key == node or key.startswith(f"{node}.")


def _names(keys: Sequence[str], reserved: set[str]) -> dict[str, str]:
    """For each key its shortest ending that is unique and free, joined by underscores."""
    names: dict[str, str] = {}
    for key in keys:
        taken = reserved | set(names.values())
        names[key] = next(
            (name for name in endings(key) if name not in taken), f"swept_{endings(key)[-1]}"
        )
    return names


def endings(key: str) -> list[str]:
    """Names that a dotted key may have as a dimension, the shortest first."""
    parts = key.split(".")
    return ["_".join(parts[n:]) for n in range(len(parts) - 1, -1, -1)]
