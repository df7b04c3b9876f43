"""README and docs do as they say: their Python code runs, their commands run, their links lead somewhere."""

import contextlib
import functools
import importlib.util
import re
import shlex
import subprocess
import sys
from pathlib import Path

import matplotlib
import mujoco
import pytest
import zmpwalk
from zmpwalk import cli

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
HOWTOS = sorted((DOCS / "howto").glob("*.md"))
PAGES = [ROOT / "README.md", *sorted(DOCS.rglob("*.md"))]
NEEDS = {"gym.md": "gymnasium"}
LONGEST = 15  # lines of a how-to's code
SHORT_WALK = 2.0  # [s] in which a walk of these pages has shown what it shows; the others walk as long as they say
ALL_OF_IT = ("pushes.md", "push.md", "circle.md", "compare.md")
# Appended to a command, so that it does the same for less time; the last of two equal options counts.
SHORTER = {
    "walk": "--duration 1 --no-figures",
    "video": "--duration 0.4 --size 160x120 --fps 5",
    "push-map": "--directions 1 --phases 1 --stance left --limit 0.1 --no-figures",
    "robustness": "--duration 4 --only noise --no-figures",
    "bench": "--duration 1 --part plan",
    "sweep": "--no-figures",
}
# What these would need is not here: a screen, a cluster, the extra `robots`. Their words are parsed.
PARSED_ONLY = ("zmpwalk view", "--cluster", "menagerie:")
NOT_OURS = ("pip", "make", "git", "python benchmarks", "python docs")


def name_of(page):
    return page.relative_to(ROOT).as_posix()


def blocks(page, language):
    """Code of a page in the order in which it stands there."""
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text(encoding="utf-8"), re.S | re.M)


def python_code(page):
    return "".join(blocks(page, "python"))


def commands(page):
    """Lines that a reader types: those of shell blocks, and those in the text that begin with `zmpwalk `."""
    lines = [line for block in blocks(page, "sh") for line in block.splitlines()]
    return [line for line in lines if line.strip() and not line.startswith(NOT_OURS)]


def words_of(command):
    """A command's words, and the file that takes what it prints."""
    words = shlex.split(command, comments=True)
    return (words[:-2], words[-1]) if ">" in words else (words, None)


def parse(words):
    """Lets the command line take these words, without running them."""
    command = cli.cli.get_command(None, words[1])
    assert command is not None, words
    if len(words) == 2:
        return  # the text speaks of the command
    with command.make_context(words[1], list(words[2:])):
        pass


@pytest.fixture
def reader(tmp_path, monkeypatch):
    """A folder with what readers have in theirs: a robot of their own, and a walk of it that is under way."""
    monkeypatch.chdir(tmp_path)
    matplotlib.use("Agg")
    model, description = zmpwalk.load_robot("mahru")
    mjcf = (Path(zmpwalk.__file__).parent / "robots" / "mahru.xml").read_text(encoding="utf-8")
    for file in ("my.xml", "n1.xml"):
        Path(file).write_text(mjcf, encoding="utf-8")
    for folder in (".", "path/to", "my"):
        Path(folder).mkdir(parents=True, exist_ok=True)
        Path(folder, "my.xml").write_text(mjcf, encoding="utf-8")
        assert cli.main(["inspect", f"{folder}/my.xml", "--write", f"{folder}/robot.json"]) == 0
    for text in blocks(DOCS / "sweep.md", "toml"):
        Path("speeds.toml").write_text(text.replace("8.0", "0.5").replace("count = 8", "count = 2"), encoding="utf-8")
    data = mujoco.MjData(model)
    description.place(model, data)
    controller = zmpwalk.WalkingController(model, description)
    controller.reset(data)
    short = functools.partial(zmpwalk.push_map, directions=1, phases=1, stances=["left"], limit=0.1)
    monkeypatch.setattr(zmpwalk, "push_map", short, raising=False)
    return {"zmpwalk": zmpwalk, "model": model, "data": data, "controller": controller}


@pytest.mark.parametrize("page", [page for page in PAGES if python_code(page)], ids=name_of)
def test_python_code_of_a_page_runs_from_top_to_bottom(page, reader):
    if page.name in NEEDS:
        pytest.importorskip(NEEDS[page.name])
    for block in blocks(page, "python"):
        code = (
            block
            if page.name in ALL_OF_IT
            else re.sub(r"(\bduration=|\bdata\.time < )[\d.]+", rf"\g<1>{SHORT_WALK}", block)
        )
        exec(compile(code, name_of(page), "exec"), reader)


@pytest.mark.parametrize("page", [page for page in PAGES if commands(page)], ids=name_of)
def test_commands_of_a_page_run_one_after_the_other(page, reader, capsys):
    for command in commands(page):
        words, file = words_of(command)
        if words[0] == "python":
            subprocess.run([sys.executable, *words[1:]], check=True, timeout=120)
            continue
        assert words[0] == "zmpwalk", f"{command}: nobody runs this"
        if any(part in command for part in PARSED_ONLY):
            parse(words)
            continue
        short = SHORTER.get(words[1], "").split()
        if words[1] == "video" and words[2].endswith(".npz"):
            short = short[2:]  # a film of a recorded walk is as long as that
        with contextlib.ExitStack() as stack:
            if file:
                stack.enter_context(contextlib.redirect_stdout(stack.enter_context(open(file, "w", encoding="utf-8"))))
            code = cli.main([*words[1:], *short])
        fell = 3  # as it may where somebody pushes
        assert code in (0, fell), f"{command}\n{capsys.readouterr().err}"


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_commands_in_the_text_are_taken(page):
    for command in re.findall(r"`(zmpwalk [a-z][^`\n]*)`", page.read_text(encoding="utf-8")):
        words, _ = words_of(re.sub(r"\b[A-Z]+(\.\w+)?(\.\.\.)?(?= |$)", str(__file__), command))
        parse(words)
    for script in re.findall(r"`python ((?:benchmarks|docs)/[\w/]+\.py)", page.read_text(encoding="utf-8")):
        assert (ROOT / script).is_file(), script


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_links_lead_to_files_and_headings_that_are_there(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
        if target.startswith("http"):
            continue
        file, _, heading = target.partition("#")
        led = (page.parent / file).resolve() if file else page
        assert led.exists(), f"{name_of(page)} links to {target}"
        if heading:
            anchors = re.findall(r"^#+ (.*)$", led.read_text(encoding="utf-8"), re.M)
            assert heading in [re.sub(r"[^\w\- ]", "", a).strip().lower().replace(" ", "-") for a in anchors], target


@pytest.mark.parametrize("page", HOWTOS, ids=name_of)
def test_a_howto_is_short(page):
    lines = [line for line in python_code(page).splitlines() if line.strip()]
    assert 0 < len(lines) <= LONGEST


def test_there_are_the_howtos_that_a_newcomer_looks_for():
    assert {page.stem for page in HOWTOS} >= {"sweep_speeds", "push", "circle", "compare", "standing_torque"}


# ---- the numbers of the README

# What the README says, and the page that a benchmark writes where that number stands: as (words, page, words there).
CLAIMS = [
    (
        r"walks at ([\d.]+) m/s within its torque limits",
        "walk_anywhere.md",
        r"every torque within its limit: ([\d.]+) m/s",
    ),
    (r"falls beyond ([\d.]+) m/s", "walk_anywhere.md", r"Highest speed that is kept for 30 s: ([\d.]+) m/s"),
    (r"descriptions?, (\d+) \(MuJoCo 2\.2\.2\)", "random_robots.md", r"MuJoCo 2\.2\.2: (\d+) of 100 walk"),
    (r"all (100) \(4\.0\.0\) walk", "random_robots.md", r"MuJoCo 4\.0\.0: (\d+) of 100 walk"),
    (r"takes ([\d.]+) µs where `mj_step1`", "benchmarks.md", r"on the terms of mj_step1 \| [\d.]+ \| ([\d.]+)"),
    (r"and (\d+) µs from the state alone", "benchmarks.md", r"from the state alone \| [\d.]+ \| ([\d.]+)"),
    (r"beside (\d+) µs of `mj_step`", "benchmarks.md", r"\| mj_step \| [\d.]+ \| ([\d.]+)"),
    (r"120 s\s+runs at (\d+) × real time", "benchmarks.md", r"simulate, 120 s recorded \| ([\d.]+)"),
    (
        r"TSID takes (\d+) times as long for a cycle in double support",
        "benchmarks.md",
        r"TSID, tick, C\+\+ \|.*?\|.*?\*\*([\d.]+) ×",
    ),
    (r"and (\d+) times as\s+long in single support", "benchmarks.md", r"TSID, tick, C\+\+ \|.*?\*\*([\d.]+) ×"),
]


@pytest.mark.parametrize(("said", "page", "measured"), CLAIMS, ids=[page for _, page, _ in CLAIMS])
def test_a_number_of_the_readme_is_that_of_the_page_that_a_benchmark_writes(said, page, measured):
    claim = re.search(said, (ROOT / "README.md").read_text(encoding="utf-8"))
    values = [float(found) for found in re.findall(measured, (DOCS / page).read_text(encoding="utf-8"))]
    assert claim, f"the README does not say {said}"
    assert values, f"docs/{page} does not say {measured}"
    digits = len(claim.group(1).partition(".")[2])
    assert float(claim.group(1)) in [round(value, digits) for value in values]


def test_the_readme_prints_what_its_command_measures():
    spec = importlib.util.spec_from_file_location("make_numbers", DOCS / "make_numbers.py")
    make_numbers = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_numbers)
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for name, lines in make_numbers.blocks().items():
        block = "\n".join((f"<!-- {name} -->", *lines, "<!-- end -->"))
        assert block in readme, f"run `python docs/make_numbers.py`: {name} is now\n" + "\n".join(lines)
