"""pages.py ROOT: every link in README.md and in the pages of app/doc leads to a page, a heading or a picture that is there,
also where they are installed (config/package.cmake), and README.md links to every page."""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
readme = root / "README.md"
pages = [readme, *sorted((root / "app/doc").glob("*.md"))]
installed = {*pages, *(root / "app/pictures").glob("*.png")}
failed = False


def fail(words):
    global failed
    failed = True
    print(words)


def text_of(page):
    """The page without its code, in which brackets are no links and # begins no heading."""
    return re.sub(r"(?ms)^ *```.*?^ *```$", "", page.read_text())


def places_in(page):
    """The anchors that GitHub gives to a page's headings."""
    headings = re.findall(r"(?m)^#+ (.*)$", text_of(page))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


linked = set()
for page in pages:
    for target in re.findall(r"\]\(([^)\s]+)\)", text_of(page)):
        if target.startswith(("http://", "https://")):
            continue
        name, _, place = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        if page == readme:
            linked.add(file)
        if file not in installed:
            fail(f"{page}: the link to {target} leads to no page and no picture that is installed with it")
        elif place and place not in places_in(file):
            fail(f"{page}: the link to {target}: that page has no such heading, it has {sorted(places_in(file))}")
for page in pages[1:]:
    if page not in linked:
        fail(f"{readme} has no link to {page}")
print(f"{len(pages)} pages")
sys.exit(1 if failed or len(pages) < 3 else 0)
