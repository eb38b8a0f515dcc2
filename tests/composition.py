"""What Hydra makes of `conf/` for one choice of groups, kept for the next: a sixth of the time.

Values are put in anew each time, by Hydra; so are groups where a folder of the user's own is given.
"""

import copy

import hydra._internal.config_loader_impl as loader
from hydra._internal.defaults_list import DefaultsList, Overrides

from squat.config.raw import CONF

_LISTED = loader.create_defaults_list
_COMPOSED = loader.ConfigLoaderImpl._compose_config_from_defaults_list
_PATHS = ["hydra.conf", str(CONF), ""]
_defaults, _configs = {}, {}


def remember():
    """Let Hydra keep, in this process, what it reads."""
    loader.create_defaults_list = _list
    loader.ConfigLoaderImpl._compose_config_from_defaults_list = _compose


def _list(repo, config_name, overrides_list, prepend_hydra, skip_missing):
    def listed():
        return _LISTED(repo, config_name, overrides_list, prepend_hydra, skip_missing)

    if _paths(repo) != _PATHS:
        return listed()
    groups = [o.input_line for o in overrides_list if repo.group_exists(o.key_or_group)]
    kept = _kept(_defaults, (config_name, prepend_hydra, skip_missing, *groups), listed)
    own = Overrides(repo=repo, overrides_list=overrides_list).config_overrides
    return DefaultsList(kept.defaults, kept.defaults_tree, own, kept.overrides)


def _compose(self, defaults, repo):
    if _paths(repo) != _PATHS:
        return _COMPOSED(self, defaults, repo)
    return copy.deepcopy(_kept(_configs, repr(defaults), lambda: _COMPOSED(self, defaults, repo)))


def _paths(repo):
    return [source.path for source in repo.get_sources()]


def _kept(store, key, make):
    if key not in store:
        store[key] = make()
    return store[key]
