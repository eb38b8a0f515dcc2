"""The report in a real browser: `make test-report` (after `make reproduce`)."""

from pathlib import Path

import pytest

from tests.report.browser import Browser

pytestmark = pytest.mark.browser
REPORT = Path(__file__).parents[2] / "results" / "report.html"
SEEN = """[...document.images].filter(image => {
  const box = image.getBoundingClientRect();
  const frame = (image.closest(".scroll") ?? image).getBoundingClientRect();
  return image.complete && image.naturalWidth > 0 && box.height > 40
    && box.width > 0.5 * Math.min(image.naturalWidth, innerWidth)
    && box.left >= 0 && frame.right <= document.documentElement.clientWidth;
}).length"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    assert REPORT.exists(), f"{REPORT} is missing: make reproduce writes it"
    with Browser(tmp_path_factory.mktemp("profile")) as opened:
        yield opened


@pytest.mark.parametrize("width", [1280, 400])
def test_all_is_seen_nothing_is_asked_for_and_nothing_fails(browser, width):
    browser.open(REPORT, width)
    assert browser.complaints == []
    assert browser.requests == []
    assert browser.value(SEEN) == browser.value("document.images.length") > 0
    assert browser.value("document.documentElement.scrollWidth") <= width
    folder = REPORT.parents[1] / "build"
    folder.mkdir(exist_ok=True)
    browser.screenshot(folder / f"report-{width}.png")


def test_the_summary_fits_one_screen(browser):
    browser.open(REPORT, 1280)
    assert browser.value("document.querySelector('header').getBoundingClientRect().bottom") <= 900


def test_the_instrument_notices_requests_errors_and_hidden_pictures(browser, tmp_path):
    page = tmp_path / "bad.html"
    page.write_text('<img src="http://127.0.0.1:9/a.png"><script>console.error("no")</script>')
    browser.open(page, 400)
    assert browser.requests == ["http://127.0.0.1:9/a.png"]
    assert len(browser.complaints) == 2
    assert browser.value(SEEN) == 0
