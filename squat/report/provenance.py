"""Where the numbers of a report come from: the same on every machine that computes the same."""

import hashlib
import json
from typing import Any, NamedTuple

from h5netcdf import File

from squat.catalogue.flat import flatten
from squat.report.members import Members

_DIGITS = 12


class Origin(NamedTuple):
    """A dataset: file, kind, digests of its configuration and values, revision that made it."""

    file: str
    kind: str
    config: str
    values: str
    revision: str


class Provenance(NamedTuple):
    """All datasets of a report, and versions (several where they were made with several)."""

    origins: list[Origin]
    versions: list[tuple[str, str]]


def provenance(members: Members) -> Provenance:
    """Provenance of every dataset that belongs to the report."""
    origins, versions = [], dict[str, set[str]]()
    for path in members.datasets:
        with File(path, "r") as file:
            attrs = {name: str(value) for name, value in file.attrs.items()}
        if not attrs.get("schema", "").startswith("squat/") or "config" not in attrs:
            continue
        origins.append(
            Origin(
                members.name(path),
                attrs["schema"].split("/")[1],
                digest(json.loads(attrs["config"])),
                attrs.get("content_sha256", "")[:_DIGITS],
                attrs.get("git_revision", "unknown"),
            )
        )
        for name, version in json.loads(attrs.get("versions", "{}")).items():
            versions.setdefault(name, set()).add(version)
    return Provenance(origins, [(name, ", ".join(sorted(v))) for name, v in versions.items()])


def digest(config: dict[str, Any]) -> str:
    """First digits of the SHA-256 over a configuration without the paths of its files."""
    text = json.dumps(flatten(config), sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:_DIGITS]
