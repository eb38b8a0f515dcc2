"""What tests keep of Hydra's work changes nothing that is composed."""

import hydra._internal.config_loader_impl as loader

from squat.config.compose import composed
from squat.errors import InputError
from tests import composition

CASES = [
    ("transient", "mesh=coarse", "current=2"),
    ("transient", "mesh=coarse", "current=3"),
    ("transient", "hull=lewis", "hull.draft=9"),
    ("transient", "hull=lewis"),
    ("transient", "coupling=newmark", "accelerator@coupling.accelerator=monolithic"),
    ("inertia", "cases/inertia@cells=table4_small"),
    ("trim", "cases/trim@_global_=small"),
    ("piston", "~piston.mass_ratio"),
    ("piston", "+no=1"),
    ("piston", "no=1"),
    ("transient", "hull=no"),
]


def made():
    for case in CASES:
        try:
            yield composed(*case)
        except InputError as error:
            yield str(error)


def test_kept_choices_of_groups_compose_as_fresh_ones(monkeypatch):
    first, again = list(made()), list(made())
    assert loader.create_defaults_list is composition._list
    monkeypatch.setattr(loader, "create_defaults_list", composition._LISTED)
    monkeypatch.setattr(
        loader.ConfigLoaderImpl,
        "_compose_config_from_defaults_list",
        composition._COMPOSED,
    )
    fresh = list(made())
    assert first == again == fresh
    assert sum(isinstance(one, str) for one in fresh) == 2
