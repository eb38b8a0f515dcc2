"""Files tell what was chosen of `conf/`; tables, pictures and differences name runs by it."""

import json
from pathlib import Path

import pandas as pd
import pytest

import squat as api
from squat.catalogue import columns, find, select, varying
from squat.catalogue.difference import difference
from squat.catalogue.flat import row_of
from squat.catalogue.telling import named, telling
from squat.config import composed
from squat.errors import InputError
from squat.figures.compare import draw
from squat.figures.labels import of_ships
from squat.records.provenance import choices_of, seal

OWN = {
    "feeder": "[[0, 0], [0, -4], [8, -6], [30, -6], [36, -3], [36, 0]]",
    "coaster": "[[0, 0], [0, -5], [40, -5], [40, 0]]",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Two hull files of a user, a run of each in two depths, and one of another shape."""
    folder = tmp_path_factory.mktemp("own")
    (folder / "conf/hull").mkdir(parents=True)
    for name, points in OWN.items():
        text = f"defaults: [polygon, _self_]\nwall: 0.5\npoints: {points}\n"
        (folder / f"conf/hull/{name}.yaml").write_text(text)
        for depth in (10, 12):
            run = _run(folder, f"hull={name}", f"channel.depth={depth}")
            run.to_netcdf(folder / f"{name}-{depth}.nc", engine="h5netcdf")
    return folder


def _run(folder, *keys):
    return api.run("equilibria", f"hydra.searchpath=[file://{folder / 'conf'}]", *keys)


def _older(run, path):
    """`run` as a file of before choices were kept."""
    older = run.copy()
    del older.attrs["choices"]
    older.to_netcdf(path, engine="h5netcdf")


def test_a_record_keeps_its_choices_and_they_change_nothing_else(folder):
    run = _run(folder, "hull=feeder")
    assert choices_of(run.attrs).items() >= {"hull": "feeder", "channel": "paper"}.items()
    points = f"hull.points={OWN['feeder']}"
    same = api.run("equilibria", "hull=polygon", "hull.wall=0.5", points)
    assert choices_of(same.attrs)["hull"] == "polygon"
    assert same.attrs["config"] == run.attrs["config"]
    assert same.attrs["content_sha256"] == run.attrs["content_sha256"]


def test_groups_that_are_put_elsewhere_are_no_choices_and_neither_are_hydras():
    groups = {"reduced", "coupling", "time", "accuracy", "mesh", "water", "channel", "hull"}
    assert set(composed("convergence").choices) == groups


def test_the_command_keeps_the_choices_and_skips_jobs_that_older_files_answer(squat, tmp_path):
    line = "-m", "task=equilibria", "hull=fig7,rectangle"
    done = squat(*line)
    assert done.returncode == 0, done.stderr
    table = find([tmp_path]).set_index("hull")
    assert sorted(table.index) == ["fig7", "rectangle"]
    path = Path(table.loc["fig7", "file"])
    older = api.open_run(path)
    del older.attrs["choices"]
    older.attrs["record_sha256"] = seal(older)
    older.to_netcdf(path, engine="h5netcdf")
    before = path.read_bytes()
    assert "2 skipped" in squat(*line).stderr
    assert path.read_bytes() == before


def test_conditions_and_orders_take_a_choice(folder):
    table = select(find([folder]), "hull == 'feeder' and channel.depth > 11")
    assert [Path(file).name for file in table["file"]] == ["feeder-12.nc"]
    assert len(select(find([folder]), "hull.isin(['coaster'])")) == 2
    assert list(select(find([folder]), "", ["-hull"])["hull"].unique()) == ["feeder", "coaster"]


def test_what_a_choice_implies_is_not_printed_and_what_it_does_not_is(folder):
    table = find([folder])
    keys = [name for name in columns(table, ()) if not name.startswith("result.")]
    assert keys == ["file", "kind", "status", "hull", "channel.depth"]
    table["hull.draft"] = [5.0, 6.0, 7.0, 8.0]
    assert "hull.draft" in columns(table, ())
    assert "hull.points" not in columns(table, ())


def test_a_difference_names_the_choice(folder):
    found = difference(folder / "feeder-10.nc", folder / "coaster-10.nc").set_index("key")
    assert found.loc["hull"].tolist() == ["feeder", "coaster"]
    assert "channel" not in found.index


def test_files_without_choices_differ_by_their_keys_alone(folder, tmp_path):
    new, old = folder / "feeder-10.nc", tmp_path / "old.nc"
    _older(api.open_run(new), old)
    assert difference(new, old).empty
    assert varying(find([new, old])) == []
    assert "hull" not in find([old])
    other = folder / "coaster-10.nc"
    _older(api.open_run(other), tmp_path / "older.nc")
    table = find([tmp_path, new, other])
    assert {"hull", "hull.points"} <= set(columns(table, ()))  # nothing else tells the older two


def test_a_key_of_the_name_of_a_group_stays_itself():
    attributes = {"choices": '{"scheme": "mine", "hull": "v"}', "config": '{"scheme": "corrected"}'}
    assert row_of(attributes) == {"scheme": "corrected", "hull": "v"}


def test_legends_name_the_choice(folder):
    table = select(find([folder]), "channel.depth == 10")
    (axes,) = draw(table, "stable", None).axes
    assert {line.get_label() for line in axes.lines} == {"hull = feeder", "hull = coaster"}
    runs = [_run(folder, f"hull={name}") for name in OWN]
    assert of_ships(runs) == ["hull = feeder", "hull = coaster"]


def test_a_figure_is_plotted_over_a_choice_and_over_a_part_of_one_in_one_line(folder):
    table = find([folder])
    for over in ("hull", "hull.draft"):
        (axes,) = draw(table, "result.squat_speed", over).axes
        labels = [line.get_label() for line in axes.lines]
        assert labels == ["depth = 10", "depth = 12"]
        assert all(len(line.get_xdata()) == len(OWN) for line in axes.lines)
        joined = "None" if over == "hull" else "-"
        assert {(line.get_linestyle(), line.get_marker()) for line in axes.lines} == {(joined, "o")}
    (axes,) = draw(table, "result.squat_speed", "channel.depth").axes
    assert {line.get_label() for line in axes.lines} == {"hull = feeder", "hull = coaster"}


def test_what_a_run_is_tells_before_how_long_it_is():
    table = pd.DataFrame({"time.periods": [3.0, 6.0], "modes": ["heave", "heave pitch"]})
    assert telling(table) == ["modes"]
    assert telling(table[["time.periods"]]) == ["time.periods"]


def test_a_choice_tells_before_its_own_name_does_unless_a_run_lacks_it():
    table = pd.DataFrame(
        {
            "coupling.name": ["printed", "newmark"],
            "coupling": ["printed", "mine"],
            "mesh": ["coarse", None],
            "mesh.near": [1.0, 2.0],
        }
    )
    assert telling(table) == ["coupling"]
    assert telling(table[["mesh", "mesh.near"]]) == ["mesh.near"]
    assert named({"coupling": "mine", "coupling.accelerator.name": "none"}) == (
        "coupling = mine, accelerator = none"
    )


def test_choices_are_plain_text(folder):
    held = json.loads(api.open_run(folder / "feeder-10.nc").attrs["choices"])
    assert all(isinstance(choice, str) for choice in held.values())


def test_a_misspelt_parent_or_none_in_a_file_of_ones_own_is_one_line(tmp_path):
    """Neither Hydra's search path nor an unknown key: the file, and what it should say."""
    (tmp_path / "conf/hull").mkdir(parents=True)
    where = f"hydra.searchpath=[file://{tmp_path / 'conf'}]"
    for text, said in (
        ("defaults: [polygn, _self_]", r"^hull/mine\.yaml: defaults: hull/polygn: unknown; give"),
        ("points: [[0, 0], [0, -4], [9, 0]]", r"defaults: \[NAME, _self_\] in the file of hull="),
    ):
        (tmp_path / "conf/hull/mine.yaml").write_text(text + "\n")
        with pytest.raises(InputError, match=said) as caught:
            api.run("mesh", where, "hull=mine")
        assert "\n" not in str(caught.value)
