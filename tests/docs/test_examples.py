"""The examples of README and docs run as they stand, a page's blocks in order in one folder."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BLOCK = re.compile(
    r"^(?:<!-- skip: (?P<skip>.+?) -->\n)?```(?P<language>sh|python)\n(?P<code>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)
PAGES = [
    page
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    if BLOCK.search(page.read_text())
]
NAMES = [str(page.relative_to(ROOT)) for page in PAGES]


def blocks(page):
    """Language and code of each block, those with a reason to skip left out."""
    found = BLOCK.finditer(page.read_text())
    return [(block["language"], block["code"]) for block in found if not block["skip"]]


def script(page):
    """One Python program of all blocks: what a page defines above is there below."""
    lines = ["import subprocess", "from tests.docs.commands import command"]
    for language, code in blocks(page):
        words = [line for line in code.splitlines() if line.strip() and not line.startswith(" ")]
        if language == "python":
            lines.append(code)
        elif all(line.startswith(("squat ", "cd ")) for line in words):
            lines += [f"command({line!r})" for line in words]
        else:
            shell = ["bash", "-euo", "pipefail", "-c", code]
            lines.append(f"subprocess.run({shell!r}, check=True, stdin=subprocess.DEVNULL)")
    return "\n".join(lines)


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_examples_run(page, tmp_path, forks):
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "PYTHONPATH": str(ROOT)}
    environment["PATH"] = forks.path()
    done = subprocess.run(
        [sys.executable, "-c", script(page)],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-3000:]


def test_every_page_is_in_the_contents():
    index = (ROOT / "docs" / "index.md").read_text()
    for page in (ROOT / "docs").rglob("*.md"):
        name = page.relative_to(ROOT / "docs").with_suffix("").as_posix()
        assert name == "index" or name in index or f"{name.rsplit('/', 1)[0]}/*" in index, name
