"""Measured tables in the docs: each stands between `<!-- NAME -->` and `<!-- end -->`."""

import re


def write_blocks(path, blocks):
    """Replaces blocks of a page.

    Args:
        path: the page (pathlib.Path).
        blocks: name -> lines.

    Raises:
        SystemExit: the page does not have that block once; nothing is written.
    """
    page = path.read_text(encoding="utf-8")
    for name, lines in blocks.items():
        block = "\n".join((f"<!-- {name} -->", *lines, "<!-- end -->"))
        page, count = re.subn(f"<!-- {name} -->.*?<!-- end -->", lambda _, block=block: block, page, flags=re.DOTALL)
        if count != 1:
            raise SystemExit(f"{path}: it needs <!-- {name} --> ... <!-- end --> once, this has it {count} times")
    path.write_text(page, encoding="utf-8")
