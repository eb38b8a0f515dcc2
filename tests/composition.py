"""What Hydra makes of `conf/` for one choice of groups, kept for the next: a sixth of the time.

Values are put in anew each time, by Hydra; so are groups where a folder of the user's own is given.
"""

import hydra._internal.config_loader_impl as loader
from hydra._internal.defaults_list import DefaultsList, Overrides

from squat.config.raw import CONF

_LISTED = loader.create_defaults_list
_COMPOSED = loader.ConfigLoaderImpl._compose_config_from_defaults_list
_PATHS = ["hydra.conf", str(CONF), ""]


def keep(kept):
    """Let Hydra ask `kept(key, make)` for what it reads."""

    def listed(repo, config_name, overrides_list, prepend_hydra, skip_missing):
        def make():
            return _LISTED(repo, config_name, overrides_list, prepend_hydra, skip_missing)

        if _paths(repo) != _PATHS:
            return make()
        groups = [o.input_line for o in overrides_list if repo.group_exists(o.key_or_group)]
        key = (_state(), config_name, prepend_hydra, skip_missing, *groups)
        found = kept(("defaults", key), make)
        own = Overrides(repo=repo, overrides_list=overrides_list).config_overrides
        return DefaultsList(found.defaults, found.defaults_tree, own, found.overrides)

    def composed(self, defaults, repo):
        if _paths(repo) != _PATHS:
            return _COMPOSED(self, defaults, repo)
        key = ("composed", _state(), repr(defaults))
        return kept(key, lambda: _COMPOSED(self, defaults, repo))

    loader.create_defaults_list = listed
    loader.ConfigLoaderImpl._compose_config_from_defaults_list = composed


def _paths(repo):
    return [source.path for source in repo.get_sources()]


def _state():
    """Names and dates of the files of `conf/`: tests change some, in trees of their own."""
    return [(str(path), path.stat().st_mtime_ns) for path in sorted(CONF.rglob("*.yaml"))]
