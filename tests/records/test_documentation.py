"""docs/datasets.md names every variable of every kind, with its unit and meaning."""

from pathlib import Path

from squat.records import KINDS

PAGE = (Path(__file__).parents[2] / "docs" / "datasets.md").read_text()


def test_every_variable_is_explained():
    for kind in KINDS.values():
        section = PAGE.split(f"## `{kind.name}`:")[1].split("\n## ")[0]
        for name, variable in kind.variables.items():
            meaning = variable.long_name.replace("|", "\\|")
            assert f"| `{name}` |" in section
            assert f"| {variable.units} | {meaning} |" in section
