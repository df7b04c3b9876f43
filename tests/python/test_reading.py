"""A reader with the paper finds any equation: NOTATION.md says where it is defined, what a walk runs, what holds it.

The sources are read as text. A function is in reach of another where its name is called in the other's body, whatever
the object, so that what is out of reach here is out of reach indeed.
"""

import re
from collections import defaultdict
from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace

import pytest

ROOT = Path(__file__).parents[2]
CPP = ROOT / "cpp"
EQUATIONS = range(1, 19)
SECTIONS = ("III-B", "III-C", "III-D")
ROWS = [*(f"({n})" for n in EQUATIONS), *SECTIONS]
SYMBOLS = ("paper", "code", "shape")
TAG = re.compile(r"//+\s*Eq\.\s*\((\d+)\)")
NAME = re.compile(r"`([A-Za-z_]\w*(?:::\w+)*)`")
WALK = "WalkingController::update"
APART = ("WholeBodyController::prepare_textbook",)  # what a walk runs only where a setting asks for it, here `textbook`
# How the formula of an equation looks in code, either language. It stands once.
FORMULAS = {
    1: r"\bLambda \* f_star\b",
    2: r"\bIdentity\(.*\) - J_c\w*\.transpose\(\) \* JbarT",
    3: r"\binverse_spd\(J ",
    5: r"- Lambda \* drift\b",
    7: r"\bJ_k\.transpose\(\) \* F\b",
    8: r"\bkp\w* \* \w*error.* \+ kd\w* \* ",
    10: r"\bsolveInPlace\(Lambda_c",
    14: r"-\s?M\w*\.y\(\) / F\w*\.z\(\)|-m_y / f_z\b|- n\.z\(\) \* M\.y\(\) \+ h \* F\.x\(\)\) / load",
    15: r"\bM\w*\.x\(\) / F\w*\.z\(\)|\bm_x / f_z\b|\(n\.z\(\) \* M\.x\(\) .* \+ h \* F\.y\(\)\) / load",
    16: r"\(ch - 1(\.0)?\) \*|\bcosh\([^()]*\) - 1\b",
    18: r"\bsinh\([^()]*\) \* .*\bcosh\([^()]*\) \* ",
}


# ---- the sources


def bare(text):
    """`text` with comments, strings and preprocessor lines blanked out; every character stays in its place."""
    no_code = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*'
    return re.sub(no_code, lambda found: re.sub(r"[^\n]", " ", found.group()), text, flags=re.S | re.M)


def closing(text, at):
    """Where the bracket that opens at `at` is closed."""
    pairs = {"(": ")", "{": "}"}
    depth, opens, closes = 0, text[at], pairs[text[at]]
    for i in range(at, len(text)):
        depth += (text[i] == opens) - (text[i] == closes)
        if depth == 0:
            return i
    raise AssertionError(f"'{opens}' is not closed")


def definitions(text):
    """(name, first character, last character) of every function that bare `text` defines, methods as Class::name."""
    found, scopes, start, at = [], [], 0, 0
    while at < len(text):
        c = text[at]
        if c == "(":
            at = closing(text, at)
        elif c in ";}":
            if c == "}" and scopes:
                scopes.pop()
            start = at + 1
        elif c == "{":
            head = re.sub(r"__attribute__\s*\(\(.*?\)\)", lambda found: " " * len(found.group()), text[start:at])
            kind = re.search(r"\b(namespace|class|struct|enum|union)\b\s*(?:class\s+)?(\w*)[^()]*$", head)
            function = re.search(
                r"((?:\w+::)*~?\w+|operator\S+)\s*\(", re.sub(r"__attribute__\s*\(\(.*?\)\)", "", head)
            )
            if kind and kind.group(1) != "enum":
                scopes.append(kind.group(2) if kind.group(1) in ("class", "struct") else "")
                start = at + 1
            elif function and not kind and re.search(r"[)}]\s*(?:(?:const|noexcept|override)\s*)*$", head):
                end = closing(text, at)
                name = "::".join([scope for scope in scopes if scope] + [function.group(1)])
                found.append((name, start + len(head) - len(head.lstrip()), end))
                at, start = end, end + 1
            else:  # an enumeration, or a member that is initialised with braces
                at = closing(text, at)
                if kind:
                    start = at + 1
        at += 1
    return found


@lru_cache(maxsize=None)
def sources():
    """Path under cpp/ -> text, with and without comments, and functions of every C++ file."""
    files = {}
    for path in sorted([*CPP.rglob("*.hpp"), *CPP.rglob("*.cpp")]):
        text = path.read_text(encoding="utf-8")
        code = bare(text)
        files[path.relative_to(CPP).as_posix()] = SimpleNamespace(text=text, code=code, functions=definitions(code))
    return files


@lru_cache(maxsize=None)
def bodies():
    """Name of each function -> the code of its definitions, from the name on."""
    found = defaultdict(str)
    for file in sources().values():
        for name, first, last in file.functions:
            found[name] += file.code[first : last + 1] + "\n"
    return dict(found)


def calls(body, name):
    """Whether `body` calls a function of this name, or makes a value of the class whose constructor it is."""
    *scope, last = name.split("::")
    made = rf"|\b{last}\b(?:<[^;()]*>)?\s+\w+\s*[({{]" if scope and scope[-1] == last else ""
    return re.search(rf"\b{re.escape(last)}\b(?:<[^;()]*>)?\s*[({{]{made}", body) is not None


@lru_cache(maxsize=None)
def reach(without=()):
    """Every function that a cycle of the walk may run, those `without` not entered."""
    every = bodies()
    reached, waiting = set(), [WALK]
    while waiting:
        name = waiting.pop()
        if name in reached or name in without:
            continue
        reached.add(name)
        body = every[name].split("(", 1)[1]
        waiting += [other for other in every if other not in reached and calls(body, other)]
    return reached


def every_test():
    """Names of all tests, both languages."""
    cpp = re.compile(r"BOOST_(?:AUTO|DATA)_TEST_CASE\(\s*(\w+)")
    found = [cpp.findall(path.read_text(encoding="utf-8")) for path in (ROOT / "tests" / "cpp").glob("*.cpp")]
    python = re.compile(r"^def (test_\w+)", re.M)
    found += [python.findall(path.read_text(encoding="utf-8")) for path in (ROOT / "tests" / "python").glob("*.py")]
    return {name for names in found for name in names}


def files_of(stem):
    """Header and body of a room's file, such as `zmp/estimate`."""
    return [name for name in (f"include/zmpwalk/{stem}.hpp", f"src/{stem}.cpp") if name in sources()]


# ---- the page


def section(heading):
    text = (CPP / "NOTATION.md").read_text(encoding="utf-8")
    _, found, rest = text.partition(f"\n## {heading}\n")
    assert found, f"cpp/NOTATION.md has no heading '{heading}'"
    return rest.split("\n## ")[0]


def table(heading, columns):
    """Rows of the first table under a heading, cells by the names `columns`."""
    rows = [line.strip()[1:-1].split("|") for line in section(heading).splitlines() if line.startswith("|")]
    assert all(len(row) == len(columns) for row in rows), [row for row in rows if len(row) != len(columns)]
    return [SimpleNamespace(**dict(zip(columns, (cell.strip() for cell in row)))) for row in rows[2:]]


def numbers(cell):
    """The lines that a cell names, as in 'lines 2, 5'."""
    found = re.search(r"\blines? (\d+(?:, \d+)*)", cell)
    return [int(n) for n in found.group(1).split(", ")] if found else []


@pytest.fixture(scope="module")
def index():
    """The equation index: row's name -> its cells."""
    rows = table("Equation index", ("eq", "what", "defined", "called_by", "instead", "held_by"))
    assert [row.eq for row in rows] == ROWS, "every equation and section stands in the index once, in order"
    return {row.eq: row for row in rows}


@pytest.fixture(scope="module")
def derivation():
    """The direct path's derivation: number of the line -> its cells."""
    rows = table("The direct path, line by line", ("line", "what", "where", "stands_for"))
    assert [row.line for row in rows] == [str(n + 1) for n in range(len(rows))]
    return {int(row.line): row for row in rows}


@pytest.fixture(scope="module")
def tags():
    """{equation: [(file, position), ...]} of every comment `// Eq. (n)` in cpp/."""
    found = defaultdict(list)
    for name, file in sources().items():
        for match in TAG.finditer(file.text):
            found[int(match.group(1))].append((name, match.start()))
    return found


def definition(row):
    """File stem and function of a row's cell 'defined in'."""
    stem, function = re.findall(r"`([^`]+)`", row.defined)
    return stem, function


def line_at(file, position):
    text = sources()[file].text
    return text[text.rfind("\n", 0, position) + 1 : text.find("\n", position)]


# ---- where an equation is defined


@pytest.mark.parametrize("eq", ROWS)
def test_definition_is_in_the_file_that_is_named(index, eq):
    stem, function = definition(index[eq])
    assert files_of(stem), f"there is no {stem}.hpp or {stem}.cpp"
    defined = [name for file in files_of(stem) for name, _, _ in sources()[file].functions]
    assert function in defined, f"{stem} defines {', '.join(defined)}"


@pytest.mark.parametrize("equation", EQUATIONS)
def test_one_comment_marks_the_equation_and_stands_in_that_function(index, tags, equation):
    stem, function = definition(index[f"({equation})"])
    places = [(file, line_at(file, position)) for file, position in tags[equation]]
    assert len(places) == 1, f"({equation}) is marked {len(places)} times: {places}"
    file, position = tags[equation][0]
    assert file in files_of(stem), f"({equation}) is marked in {file}"
    spans = [(first, last) for name, first, last in sources()[file].functions if name == function]
    end_of_line = sources()[file].text.find("\n", position)
    assert any(first <= position and position <= max(last, end_of_line) for first, last in spans), function


@pytest.mark.parametrize("eq", SECTIONS)
def test_file_of_a_section_names_it(index, eq):
    stem, _ = definition(index[eq])
    assert any(re.search(rf"\b{eq}\b", sources()[file].text) for file in files_of(stem))


def test_no_comment_marks_an_equation_that_the_paper_does_not_have(tags):
    assert set(tags) <= set(EQUATIONS)


def test_comment_marks_code(tags):
    for equation, places in tags.items():
        for file, position in places:
            code = line_at(file, position).split("//")[0]
            assert code.strip().endswith((";", "{")), f"({equation}) marks no statement in {file}"


@pytest.mark.parametrize("equation", [7, 16])
def test_corrected_equations_say_so_on_their_line(tags, equation):
    assert "corrected" in line_at(*tags[equation][0])
    assert re.search(rf"^\|\s*\({equation}\)\s*\|", section("Corrections to the printed equations"), re.MULTILINE)


@pytest.mark.parametrize("equation", FORMULAS)
def test_formula_stands_once_in_the_sources_where_the_index_has_it(index, equation):
    _, function = definition(index[f"({equation})"])
    formula = re.compile(FORMULAS[equation])
    python = {
        path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted((ROOT / "python").rglob("*.py"))
    }
    code = {**{name: file.code for name, file in sources().items()}, **python}
    found = [(name, match.start()) for name, text in code.items() for match in formula.finditer(text)]
    assert len(found) == 1, [(name, code[name][at : at + 60].splitlines()[0]) for name, at in found]
    file, at = found[0]
    assert any(name == function and first <= at <= last for name, first, last in sources()[file].functions)


# ---- what a walk runs


def test_walk_and_what_is_apart_from_it_are_where_this_file_looks_for_them():
    assert WALK in bodies()
    assert set(APART) <= reach() - reach(without=APART)


@pytest.mark.parametrize("eq", ROWS)
def test_a_definition_that_is_called_in_a_walk_is_in_reach_of_it_and_any_other_is_not(index, eq):
    row = index[eq]
    _, function = definition(row)
    callers = NAME.findall(row.called_by)
    in_reach = reach(without=APART)
    assert callers or row.instead != "–", "nothing says what a walk runs"
    if not callers:
        assert function not in in_reach, f"a walk may run {function}: say who calls it"
    for caller in callers:
        assert caller in in_reach, f"a walk does not run {caller}"
        assert calls(bodies()[caller].split("(", 1)[1], function), f"{caller} does not call {function}"


@pytest.mark.parametrize("eq", ROWS)
def test_what_runs_in_place_of_a_definition_is_in_reach_of_the_walk(index, derivation, eq):
    row = index[eq]
    assert row.instead == "–" or numbers(row.instead) or NAME.findall(row.instead)
    assert set(numbers(row.instead)) <= set(derivation)
    for name in NAME.findall(row.instead):
        assert name in reach(without=APART), f"a walk does not run {name}"


def test_every_line_of_the_derivation_is_run_by_a_walk(derivation):
    for row in derivation.values():
        names = NAME.findall(row.where)
        assert names, row
        for name in names:
            assert name in reach(without=APART), f"line {row.line}: a walk does not run {name}"


def test_lines_and_index_agree_on_what_stands_for_what(index, derivation):
    by_line = {(eq, line) for line, row in derivation.items() for eq in re.findall(r"\(\d+\)", row.stands_for)}
    assert by_line == {(eq, line) for eq, row in index.items() for line in numbers(row.instead)}


# ---- which test holds it


@pytest.mark.parametrize("eq", ROWS)
def test_tests_that_hold_an_equation_exist(index, eq):
    names = NAME.findall(index[eq].held_by)
    assert names
    assert set(names) <= every_test()


# ---- symbols


def test_symbols_of_the_table_are_in_the_sources():
    texts = [file.text for file in sources().values()]
    texts += [path.read_text(encoding="utf-8") for path in (ROOT / "bindings").glob("*.cpp")]
    words = set(re.findall(r"\w+", " ".join(texts)))
    names = [name for row in table("Symbols", SYMBOLS) for name in re.findall(r"`([^`]+)`", row.code)]
    assert {"xi", "zmp_est", "Lambda_c"} <= set(names)
    parts = {part for name in names for part in re.findall(r"\w+", name)}
    assert parts <= words | {"W", "H", "S", "B", "L", "R", "F"}, parts - words


@pytest.mark.parametrize("frame", ["W", "H", "S", "B", "L", "R"])
def test_frame_has_a_row_among_the_symbols(frame):
    assert any(f"`{frame}`" in row.code for row in table("Symbols", SYMBOLS))
