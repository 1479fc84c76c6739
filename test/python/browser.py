"""Reports as a browser shows them: no image is broken, no link leads nowhere, nothing is wider than the
window, no script is needed, nothing is fetched.

    browser.py EPAFI WORK
"""
import html
import json
import os
import re
import subprocess
import sys
import warnings
from urllib.parse import unquote

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, read, write  # noqa: E402

WORK = absent(sys.argv[2])
import epafi  # noqa: E402

warnings.simplefilter("ignore", epafi.EpafiWarning)
SHIPPED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "drivers", "scenes")
# What a reader would see, told by the page itself.
ASKED = """<script>window.onload = function () {
  var seen = {
    images: [...document.images].map(i => [i.alt, i.naturalWidth, i.getBoundingClientRect().right]),
    links: [...document.links].map(a => [a.getAttribute("href"), a.hash !== "" &&
      document.getElementById(decodeURIComponent(a.hash.slice(1))) !== null]),
    wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
    width: document.documentElement.clientWidth,
    fetched: performance.getEntriesByType("resource").filter(r => !r.name.startsWith("data:")).length,
    results: document.querySelector(".results").getBoundingClientRect().bottom,
    text: document.body.innerText };
  document.body.innerHTML = "<pre id=seen>" + encodeURIComponent(JSON.stringify(seen)) + "</pre>";
};</script>"""


def opened(page):
    """What the browser tells of a page."""
    asked = write(page + ".asked.html", read(page).replace("</body>", ASKED + "</body>"))
    done = subprocess.run(
        ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1200,900",
         "--virtual-time-budget=10000", "--user-data-dir=" + os.path.join(WORK, "profile"),
         "--dump-dom", "file://" + os.path.abspath(asked)], text=True, capture_output=True, timeout=300)
    told = re.search(r'<pre id="seen">(.*?)</pre>', done.stdout, re.S)
    claim(told is not None, "a browser opens %s%s" % (page, "" if told else ": " + done.stderr[-500:]))
    return json.loads(unquote(html.unescape(told[1]))) if told else None


for name, settings in (("dovetail", {}), ("spheres", {}), ("fretting", {"History->Steps": [1, 2, 2, 2]})):
    run = epafi.run(os.path.join(SHIPPED, name + ".xml"), os.path.join(WORK, name), set=settings)
    seen = opened(run.report())
    if seen is None:
        continue
    claim(len(seen["images"]) > 4 and all(width > 100 and right <= seen["width"]
                                          for _, width, right in seen["images"]),
          "%s: %d images are whole, and as wide as the window at most" % (name, len(seen["images"])))
    claim(len(seen["links"]) > 5 and all(there for _, there in seen["links"]),
          "%d links lead to a part of the page" % len(seen["links"]))
    claim(seen["wide"] <= 0 and seen["fetched"] == 0, "nothing is wider, nothing is fetched")
    claim(seen["results"] < 900, "all key results are on the first screen: %g" % seen["results"])
    claim("largest pressure" in seen["text"] and not re.search(r"\bnan\b|undefined", seen["text"], re.I),
          "it is read as it is meant")
finish()
