"""A reader with the paper finds any equation: NOTATION.md names file and function, one comment marks its line."""

import re
from collections import defaultdict
from pathlib import Path

import pytest

CPP = Path(__file__).parents[2] / "cpp"
EQUATIONS = range(1, 19)
TAG = re.compile(r"//+\s*Eq\.\s*\((\d+)\)")


@pytest.fixture(scope="module")
def index():
    """{equation: (file, function)} from NOTATION's table under 'Equation index'."""
    text = (CPP / "NOTATION.md").read_text(encoding="utf-8")
    _, heading, table = text.partition("## Equation index")
    assert heading, "cpp/NOTATION.md has no heading 'Equation index'"
    rows = re.findall(r"^\|\s*\((\d+)\)\s*\|\s*`([^`]+)`\s*\|\s*`([^`]+)`\s*\|", table.split("\n## ")[0], re.MULTILINE)
    numbers = [int(number) for number, _, _ in rows]
    assert numbers == sorted(set(numbers)), "an equation stands twice in the index"
    return {int(number): (file, function) for number, file, function in rows}


@pytest.fixture(scope="module")
def tags():
    """{equation: [(file, line number), ...]} of every comment `// Eq. (n)` in cpp/."""
    found = defaultdict(list)
    for path in sorted([*CPP.rglob("*.hpp"), *CPP.rglob("*.cpp")]):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for match in TAG.finditer(line):
                found[int(match.group(1))].append((path.relative_to(CPP).as_posix(), number))
    return found


def lines_of(path, function):
    """First and last line of the definition of `function`, from its name to the closing brace."""
    text = path.read_text(encoding="utf-8")
    spans = []
    for match in re.finditer(rf"(?<![\w:]){re.escape(function)}\s*\(", text):
        depth, at = 0, text.index("(", match.start())
        while True:  # over the arguments
            depth += {"(": 1, ")": -1}.get(text[at], 0)
            at += 1
            if depth == 0:
                break
        if not re.match(r"[\s\w:]*\{", text[at:].replace("const", "")):
            continue  # a call or a declaration
        at = text.index("{", at)
        while True:  # over the body
            depth += {"{": 1, "}": -1}.get(text[at], 0)
            at += 1
            if depth == 0:
                break
        spans.append((text.count("\n", 0, match.start()) + 1, text.count("\n", 0, at) + 1))
    return spans


def test_index_has_every_equation_and_no_other(index):
    assert sorted(index) == list(EQUATIONS)


@pytest.mark.parametrize("equation", EQUATIONS)
def test_index_names_a_file_and_a_function_that_exist(index, equation):
    file, function = index[equation]
    assert (CPP / file).is_file(), file
    assert lines_of(CPP / file, function), f"{function} is not defined in {file}"


@pytest.mark.parametrize("equation", EQUATIONS)
def test_one_comment_marks_the_equation_and_stands_in_that_function(index, tags, equation):
    file, function = index[equation]
    assert len(tags[equation]) == 1, tags[equation]
    tagged, line = tags[equation][0]
    assert tagged == file
    spans = lines_of(CPP / file, function)
    assert any(first - 1 <= line <= last for first, last in spans), f"line {line} is not in {function}"


def test_no_comment_marks_an_equation_that_the_paper_does_not_have(tags):
    assert set(tags) <= set(EQUATIONS)


@pytest.mark.parametrize("equation", [7, 16])
def test_corrected_equations_say_so_on_their_line(index, tags, equation):
    file, line = tags[equation][0]
    assert "corrected" in (CPP / file).read_text(encoding="utf-8").splitlines()[line - 1]
    text = (CPP / "NOTATION.md").read_text(encoding="utf-8")
    assert re.search(rf"^\|\s*\({equation}\)\s*\|", text.split("## Corrections")[1].split("\n## ")[0], re.MULTILINE)


def test_comment_marks_code(tags):
    for equation, places in tags.items():
        for file, line in places:
            code = (CPP / file).read_text(encoding="utf-8").splitlines()[line - 1].split("//")[0]
            assert code.strip().endswith((";", "{")), f"({equation}) marks no statement: {file}:{line}"
