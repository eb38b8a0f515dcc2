"""Bad input is one line that names key, value and remedy."""

import pytest

from squat.config import CASES, compose, validate
from squat.errors import InputError


@pytest.mark.parametrize(
    ("overrides", "line"),
    [
        (["piston.mass_ratio=-1"], "piston.mass_ratio=-1: must be greater than 0"),
        (["piston.length=2e5"], "piston.length=200000.0: must be less than or equal to 100000"),
        (["piston.length=.inf"], "piston.length=.inf: must be a valid number"),
        (["piston.length=inf"], "piston.length=inf: must be"),
        (["piston.length=nan"], "piston.length=nan: must be"),
        (["piston.mass_ratio=true"], "piston.mass_ratio=True: must be a valid number"),
        (["piston.mass_ratio=abc"], "piston.mass_ratio=abc: must be a valid number"),
        (["time.steps_per_period=2.5"], "time.steps_per_period=2.5: must be a valid integer"),
        (["scheme=foo"], "scheme=foo: must be 'standard', 'corrected' or 'consistent'"),
        (["+foo=1"], "foo=1: unknown key; leave it out"),
        (["+piston.mas_ratio=1"], "piston.mas_ratio=1: unknown key; did you mean 'mass_ratio'?"),
        (["~piston.length"], "piston.length: missing; give +piston.length=VALUE"),
        (["accelerator=aitken", "accelerator.initial=3"], "accelerator.initial=3: must be less"),
        (["+accelerator.x=3"], "accelerator.x=3: unknown key"),
    ],
)
def test_bad_value_names_key_value_and_remedy(overrides, line):
    with pytest.raises(InputError) as caught:
        validate(compose("piston", *overrides))
    assert str(caught.value).startswith(line)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("overrides", "line"),
    [
        (["accuracy.refinement=1"], "accuracy.refinement=1: must be greater than or equal to 2"),
        (["channel.bottom=[[1,2,3]]"], "channel.bottom.0: [1, 2, 3] is no point; give [x, z]"),
        (
            ["hull=polygon", "hull.points=[[0,0],[0,-1],[8,-8],[110],[140,0]]"],
            "hull.points.3: [110] is no point; give [x, z], two numbers in m",
        ),
        (["hull.gravity_center=[20]"], "hull.gravity_center: [20] is no point; give [x, z]"),
        (
            ["hull=polygon", "hull.points=[[0,0],[1,-1]]"],
            "hull.points=[[0, 0], [1, -1]]: must have at least 3 items, not 2",
        ),
    ],
)
def test_bad_geometry_names_key_value_and_remedy(overrides, line):
    with pytest.raises(InputError) as caught:
        validate(compose("added_mass", *overrides))
    assert str(caught.value).startswith(line)


@pytest.mark.parametrize(
    ("task", "overrides", "line"),
    [
        ("catalogue", ["sort=1"], "sort=1: must be a list; give sort=[1]"),
        ("catalogue", ["runs=1"], "runs=1: must be a valid string"),
        ("catalogue", ["runs=[a,1]"], "runs=['a', 1]: must be a valid string"),
        ("uneven_bottom", ["gaps=0.1"], "gaps=0.1: must be a list; give gaps=[0.1]"),
        (
            "stability",
            ["portrait.heave_shares=[0.1]"],
            "portrait.heave_shares=[0.1]: has 1 entries; give 2",
        ),
        ("difference", ["runs=[v2.nc]"], "runs: two files are compared; give runs=[A.nc,B.nc]"),
        ("difference", ["runs=v2.nc"], "runs: two files are compared; give runs=[A.nc,B.nc]"),
        ("difference", ["runs=[a,b,c]"], "runs: two files are compared; give runs=[A.nc,B.nc]"),
    ],
)
def test_a_bad_list_names_key_value_and_remedy(task, overrides, line):
    with pytest.raises(InputError) as caught:
        validate(compose(task, *overrides))
    assert str(caught.value).startswith(line)
    assert "+" not in str(caught.value)


@pytest.mark.parametrize("task", ["piston", "iterations", "equilibria"])
def test_every_run_task_composes_without_overrides(task):
    valid = validate(compose(task))
    assert isinstance(valid.case, CASES[task])
    assert valid.config["task"] == task


@pytest.mark.parametrize(
    ("overrides", "line"),
    [
        (["hull.drafft=8"], "hull.drafft=8: unknown key; did you mean 'hull.draft'? squat task="),
        (["chanel.depth=11"], "chanel.depth=11: unknown key; did you mean 'channel.depth'? squat"),
        (["hul=lewis"], "hul=lewis: unknown key; did you mean 'hull'? squat"),
        (["hull=v", "~hull.wal"], "hull.wal: unknown key; did you mean 'hull.wall'? squat"),
        (
            ["hull.lenth=2", "hull.drafft=8"],
            "hull.lenth=2: unknown key; did you mean 'hull.length'",
        ),
        (["hull=lewis", "out=x.nc", "hull.segment=8"], "hull.segment=8: unknown key; did you mean"),
        (["depth=9"], "depth=9: unknown key; did you mean 'channel.depth'? squat"),
        (["drft=9"], "drft=9: unknown key; did you mean 'hull.draft'? squat"),
        (["velocity=2"], "velocity=2: unknown key; did you mean 'current'? squat"),
        (["V_inf=2"], "V_inf=2: unknown key; did you mean 'current'? squat"),
        (["zzz.qqq=1"], "zzz.qqq=1: unknown key; squat task=NAME --cfg job lists the keys"),
    ],
)
def test_a_misspelt_key_is_answered_with_the_one_that_was_meant(overrides, line):
    with pytest.raises(InputError) as caught:
        compose("limits", *overrides)
    assert str(caught.value).startswith(line)


def test_a_group_that_a_task_does_not_use_is_refused():
    with pytest.raises(InputError, match=r"^hull.draft=3: unknown key; "):
        compose("piston", "hull.draft=3")


def test_all_missing_keys_of_a_hull_are_named_at_once():
    with pytest.raises(InputError) as caught:
        validate(compose("equilibria", "hull.shape=lewis"))
    assert str(caught.value) == (
        "hull.wall, hull.area_coefficient, hull.segments: missing; "
        "give +hull.wall=VALUE +hull.area_coefficient=VALUE +hull.segments=VALUE, "
        "or begin the hull's file with defaults: [lewis, _self_]"
    )
    given = ["+hull.wall=1.0", "+hull.area_coefficient=0.9", "+hull.segments=24"]
    assert validate(compose("equilibria", "hull.shape=lewis", *given)).case.hull.wall == 1
    with pytest.raises(InputError, match=r"^hull.points, hull.wall: missing; give \+hull.points="):
        validate(compose("equilibria", "hull.shape=polygon"))


def test_unknown_task_lists_the_known_ones():
    with pytest.raises(InputError, match=r"task=nothing: unknown; give one of .*equilibria"):
        validate({"task": "nothing"})
