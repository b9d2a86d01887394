# SPDX-License-Identifier: MIT
"""The report in a real browser, at desktop and phone width."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest

BROWSER = next((path for name in ("chromium", "chromium-browser", "google-chrome", "chrome") if (path := shutil.which(name))), None)
PROBE = """<!doctype html><title>probe</title><iframe id="f" src="page.html" style="width:{width}px;height:900px;border:0"></iframe>
<p id="seen"></p><script>
document.getElementById("f").onload = function () {{
  var page = this.contentDocument, root = page.documentElement, rows = [];
  page.querySelectorAll("details").forEach(function (d) {{ d.open = true; }});
  page.querySelectorAll("article, section, header, main").forEach(function (e) {{
    if (e.getBoundingClientRect().right > {width} + 1) rows.push(e.tagName + "#" + e.id);
  }});
  document.getElementById("seen").textContent = "width " + root.scrollWidth + " of " + root.clientWidth
    + ", shown " + page.querySelectorAll("math").length + ", beyond " + rows.join(" ");
}};
</script>"""


@pytest.fixture(scope="module")
def browse(tmp_path_factory):
    """Open a folder's probe.html without a window; the page's text after its scripts have run."""
    if BROWSER is None:
        pytest.skip("no browser here: chromium is needed to lay the page out")
    profile = tmp_path_factory.mktemp("profile")

    def run(probe):
        done = subprocess.run(
            [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files", f"--user-data-dir={profile}",
             "--window-size=1600,1000", "--virtual-time-budget=5000", "--dump-dom", probe.as_uri()],
            capture_output=True, text=True, timeout=120, check=True)
        return re.search(r'id="seen">([^<]*)<', done.stdout)[1]

    return run


@pytest.mark.parametrize("width", [1280, 390], ids=["desktop", "phone"])
def test_no_part_of_the_page_is_wider_than_the_window(paper, browse, width):
    """With everything unfolded the page does not scroll sideways, and its formulas are there."""
    p = paper("ok")
    assert p.run("report", "-o", "page.html", "--jobs", "1").exit_code == 0
    (p.root / "probe.html").write_text(PROBE.format(width=width), encoding="utf-8")
    seen = re.fullmatch(r"width (\d+) of (\d+), shown (\d+), beyond (.*)", browse(p.root / "probe.html"))
    assert seen is not None
    assert int(seen[1]) <= int(seen[2]) and seen[4] == "" and int(seen[3]) > 0
