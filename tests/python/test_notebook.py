"""The course: every notebook runs from top to bottom, ends with a solved exercise, and lies here without outputs."""

import re
import time
from pathlib import Path

import nbclient
import nbformat
import pytest

FOLDER = Path(__file__).parents[2] / "notebooks"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))
LONGEST = 60.0  # [s] of a notebook on a quiet machine
BUSY = 5.0  # how much slower the machine of the tests may be


def test_the_course_has_eight_parts():
    assert [path.stem for path in NOTEBOOKS] == [
        "01_first_walk",
        "02_zmp_from_torque",
        "03_iteration",
        "04_velocity",
        "05_lateral_motion",
        "06_your_robot",
        "07_what_breaks_it",
        "08_your_study",
    ]


@pytest.fixture(params=NOTEBOOKS, ids=lambda path: path.stem)
def notebook(request):
    return nbformat.read(request.param, as_version=4)


def test_notebook_lies_cleared(notebook):
    nbformat.validate(notebook)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            assert cell.outputs == []
            assert cell.execution_count is None
    assert notebook.metadata["kernelspec"]["name"] == "python3"


def test_notebook_explains_with_equations_and_ends_with_a_solved_exercise(notebook):
    text = [cell.source if cell.cell_type == "markdown" else "" for cell in notebook.cells]
    number = int(text[0].split()[1].rstrip("."))
    assert NOTEBOOKS[number - 1].stem.startswith(f"{number:02d}_")
    assert "$" in "".join(text)
    exercise = next(k for k, words in enumerate(text) if "## Exercise" in words)
    solved = [cell for cell in notebook.cells[exercise + 1 :] if cell.cell_type == "code"]
    assert "A solution follows." in text[exercise]
    assert solved


def test_links_of_a_notebook_lead_to_files_that_are_there(notebook):
    for cell in notebook.cells:
        for target in re.findall(r"\]\(([^)\s]+)\)", cell.source) if cell.cell_type == "markdown" else ():
            assert (FOLDER / target).is_file(), target


@pytest.mark.once
def test_notebook_runs(notebook, tmp_path):
    client = nbclient.NotebookClient(
        notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}
    )
    began = time.perf_counter()
    client.execute()  # raises what a cell raises
    assert time.perf_counter() - began < BUSY * LONGEST
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(cell.execution_count for cell in code if cell.source.strip())
    outputs = [output for cell in code for output in cell.outputs]
    assert not [output for output in outputs if output.output_type == "error"]
    assert [output for output in outputs if "image/png" in output.get("data", {})]  # and shows something
    assert not [output for output in outputs if output.get("name") == "stderr"]
