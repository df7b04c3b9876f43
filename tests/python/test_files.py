"""Files are there whole or not at all, one by one and together."""

import pytest
from zmpwalk import InputError
from zmpwalk.files import as_input_error, together, whole


def write(path, text, fail=False):
    with whole(path) as draft:
        draft.write_text(text)
        assert (draft.parent, draft.suffix) == (path.parent, path.suffix)
        if fail:
            raise ZeroDivisionError


def write_two(out, fail=False):
    with together(out) as (draft, deliver):
        for name in ("a.txt", "b.txt"):
            (draft / name).write_text(name)
        assert [path.name for path in out.iterdir()] == [draft.name]
        if fail:
            raise ZeroDivisionError
        deliver([draft / "a.txt", draft / "b.txt"])


def test_a_file_is_replaced_when_the_new_one_is_whole(tmp_path):
    path = tmp_path / "walk.csv"
    write(path, "first")
    with pytest.raises(ZeroDivisionError):
        write(path, "half", fail=True)
    assert path.read_text() == "first"
    write(path, "second")
    assert path.read_text() == "second"
    assert list(tmp_path.iterdir()) == [path]


def test_outputs_appear_together_or_leave_no_folder_behind(tmp_path):
    out = tmp_path / "deep" / "out"
    with pytest.raises(ZeroDivisionError):
        write_two(out, fail=True)
    assert not list(tmp_path.iterdir())
    write_two(out)
    assert sorted(path.name for path in out.iterdir()) == ["a.txt", "b.txt"]


def test_a_path_that_cannot_be_written_is_told_in_one_sentence(tmp_path):
    write(tmp_path / "file", "")
    with pytest.raises(InputError, match=r"file/out: cannot write there: not a directory$"):
        write_two(tmp_path / "file" / "out")
    path = tmp_path / "no" / "walk.csv"
    with pytest.raises(InputError, match=r"walk\.csv: cannot write there: no such file"), as_input_error(path):
        write(path, "text")
