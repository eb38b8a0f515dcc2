"""Generated bad input: what may be typed wrongly for every key of every task."""

import random
import string
from typing import NamedTuple

from squat.config import CASES, compose
from squat.errors import InputError
from tests.fuzz import words

REQUIRED = {
    "replay": ["run=good.nc"],
    "collect": ["runs=sweep"],
    "difference": ["runs=[good.nc,other.nc]"],
    "catalogue": ["runs=sweep"],
    "compare": ["runs=sweep"],
    "figure": ["figure=fig10", "data=roots.nc"],
    "table": ["name=table7", "data=roots.nc"],
    "verdicts": [
        "tables=[t.csv]",
        *(f"{key}=good.nc" for key in ("iterations", "equilibria", "table4", "table5", "table6")),
        "trim=good.nc",
        "transients=[good.nc]",
        "pitching=[good.nc]",
    ],
}
"""Keys without which a task does not compose; the files lie in the folder of the run."""
FILES = {
    "replay": "run={}",
    "difference": "runs=[{},good.nc]",
    "catalogue": "runs={}",
    "compare": "runs={}",
    "figure": "data={}",
    "table": "data={}",
    "transient": "inputs.mesh={}",
    "reduced": "inputs.mesh={}",
    "stability_map": "inputs.reduced={}",
    "verdicts": "equilibria={}",
}
"""Keys that name files of earlier tasks."""
GROUPS = ("hull", "mesh", "channel", "water", "coupling", "accelerator", "criterion", "reduced")
TARGET = "_target_"


class Bad(NamedTuple):
    """Arguments of the command; what the line must name (any of it; nothing: just one line)."""

    sort: str
    arguments: tuple[str, ...]
    names: tuple[str, ...] = ()


def leaves(value, path=""):
    """Dotted keys and values of nested containers."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from leaves(inner, f"{path}.{key}" if path else str(key))
    else:
        yield path, value


def keys(task):
    """Keys of a task with their values, `task` itself left out."""
    config = _composed(task)
    return [(key, value) for key, value in leaves(config) if key != "task"]


def _composed(task):
    while True:
        try:
            return compose(task, *REQUIRED.setdefault(task, []))
        except InputError as error:
            key, _, _ = str(error).partition(": missing; give ")
            REQUIRED[task].append(f"{key}=good.nc")


class Generator:
    """Bad input by kind, from a seed."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.keys = {task: keys(task) for task in CASES}
        others = "typo choice deletion file target hydra options several task combined"
        self.sorts = [*words.WORDS, *others.split()]

    def bad(self):
        """One bad input (it may turn out to be good)."""
        sort = self.random.choice(self.sorts)
        make = getattr(self, sort, None)
        return make() if make else self.value(sort)

    def pick(self):
        """A task, one of its keys and that key's value."""
        task = self.random.choice(list(CASES))
        return task, *self.random.choice(self.keys[task])

    def command(self, task, *typed):
        given = {word.partition("=")[0] for word in typed}
        required = [w for w in REQUIRED.get(task, []) if w.partition("=")[0] not in given]
        return (f"task={task}", *required, *typed)

    def told(self, task, *names):
        """`names`, or none: a task whose other files are of a wrong kind may name one of these."""
        return () if task in ("verdicts", "report") else names

    def value(self, sort):
        task, key, _ = self.pick()
        word = self.random.choice(words.WORDS[sort])
        names = self.told(task, key, key.split(".")[0], word)
        return Bad(sort, self.command(task, f"{key}={word}"), names)

    def typo(self):
        task, key, _ = self.pick()
        place = self.random.randrange(len(key) + 1)
        letter = self.random.choice(string.ascii_letters + "_.-/@:")
        cut = self.random.choice([0, 1])
        wrong = key[:place] + self.random.choice([letter, ""]) + key[place + cut :]
        plus = self.random.choice(["", "+", "++", "~"])
        return Bad("typo", self.command(task, f"{plus}{wrong}=1"), (wrong, wrong.split(".")[0]))

    def choice(self):
        task, key, _ = self.pick()
        key = self.random.choice([*GROUPS, key, "task", "hydra/launcher"])
        word = self.random.choice(words.CHOICES)
        return Bad("choice", self.command(task, f"{key}={word}"), self.told(task, key, word))

    def deletion(self):
        task, key, _ = self.pick()
        key = self.random.choice([key, key.split(".")[0], "out", "hydra", "hull", "hydra.job"])
        return Bad("deletion", self.command(task, f"~{key}"), (key,))

    def file(self):
        task = self.random.choice(list(FILES))
        name = self.random.choice(words.BROKEN)
        return Bad("file", self.command(task, FILES[task].format(name)), self.told(task, name))

    def target(self):
        task, key, _ = self.pick()
        evil = self.random.choice(words.EVIL)
        typed = self.random.choice([
            [f"+{key}.{TARGET}={evil}"], [f"+{TARGET}={evil}"], [f"{key}={{{TARGET}:{evil}}}"],
            [f"+hydra.callbacks.x.{TARGET}={evil}", "+hydra.callbacks.x.name=evil.flag"],
            [f"hydra.callbacks.jobs.{TARGET}={evil}"], [f"hydra.launcher.{TARGET}={evil}"],
            [f"hydra.sweeper.{TARGET}={evil}"], ["-cd", "evil", "+user=callback"],
            ["-cd", "evil", "+user=value"], ["-cd", "evil", "+user=python"],
            ["-cd", "evil", "+user=logging"], ["-cp", "evil", "-cn", "primary"],
            [f"++hydra.job_logging={{version:1,formatters:{{x:{{'()':{evil}}}}}}}"],
        ])  # fmt: skip
        return Bad("target", self.command(task, *typed))

    def hydra(self):
        task, _, _ = self.pick()
        word = self.random.choice(words.HYDRA)
        return Bad("hydra", self.command(task, word))

    def options(self):
        task, _, _ = self.pick()
        word = self.random.choice(words.OPTIONS)
        return Bad("options", self.command(task, word))

    def several(self):
        one, two = (self.value(self.random.choice(["type", "range", "finite"])) for _ in range(2))
        return Bad("several", (*one.arguments, *two.arguments[1:]))

    def task(self):
        word = self.random.choice(words.TASKS)
        return Bad("task", (f"task={word}",), ("task", word))

    def combined(self):
        task, key, _ = self.pick()
        sort = self.random.choice(list(words.WORDS))
        word = self.random.choice(words.WORDS[sort]) + self.random.choice(words.WORDS["syntax"])
        return Bad("combined", self.command(task, f"{key}={word}"))
