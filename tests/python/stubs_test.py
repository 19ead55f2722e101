"""The stubs name every public name, and nothing else; every public thing has a docstring."""

import ast
import inspect
import pathlib

import pytest

import tumble
import tumble.plot

STUBS = {tumble: "__init__.pyi", tumble.plot: "plot.pyi"}
FOLDER = pathlib.Path(tumble.__file__).parent


def stub(module):
    return ast.parse((FOLDER / STUBS[module]).read_text())


def names_in(body):
    names = set()
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            names.add(node.target.id)
    return {name for name in names if not name.startswith("_")}


def own_members(kind):
    found = set()
    for part in kind.__mro__:
        if part.__module__.split(".")[0] == "tumble":
            found |= set(vars(part)) | set(getattr(part, "__annotations__", {}))
    return {name for name in found if not name.startswith("_")}


def test_the_package():
    assert names_in(stub(tumble).body) == set(tumble.__all__)
    assert all(hasattr(tumble, name) for name in tumble.__all__)


def test_the_plots():
    public = {name for name, value in vars(tumble.plot).items()
              if inspect.isfunction(value) and value.__module__ == "tumble.plot" and not name.startswith("_")}
    assert names_in(stub(tumble.plot).body) == public


@pytest.mark.parametrize("name", [name for name in tumble.__all__ if inspect.isclass(getattr(tumble, name))])
def test_members(name):
    kind = getattr(tumble, name)
    node = next(node for node in stub(tumble).body if isinstance(node, ast.ClassDef) and node.name == name)
    stubbed = names_in(node.body)
    for base in node.bases:
        parent = next((n for n in stub(tumble).body if isinstance(n, ast.ClassDef)
                       and n.name == getattr(base, "id", None)), None)
        stubbed |= names_in(parent.body) if parent else set()
    members = own_members(kind)
    dynamic = issubclass(kind, (tumble.Report, tumble.Channel, tumble.Answer))  # set in __init__, or of the JSON
    assert members <= stubbed, f"not in the stub: {members - stubbed}"
    assert dynamic or stubbed <= members, f"only in the stub: {stubbed - members}"


def test_signatures():
    for node in ast.walk(stub(tumble)):
        if not isinstance(node, ast.ClassDef):
            continue
        for method in node.body:
            if not isinstance(method, ast.FunctionDef) or method.name.startswith("__") or method.decorator_list:
                continue
            ours = inspect.signature(getattr(getattr(tumble, node.name), method.name))
            given = [arg.arg for arg in method.args.args + method.args.kwonlyargs]
            assert [p for p in ours.parameters if ours.parameters[p].kind not in (2, 4)] == given, (node.name, method.name)
    for node in stub(tumble).body:
        if isinstance(node, ast.FunctionDef):
            ours = inspect.signature(getattr(tumble, node.name))
            given = [arg.arg for arg in node.args.args + node.args.kwonlyargs]
            assert [p for p in ours.parameters if ours.parameters[p].kind not in (2, 4)] == given, node.name


def test_docstrings():
    for name in tumble.__all__:
        assert inspect.getdoc(getattr(tumble, name)), f"{name} has no docstring"
    for kind in (tumble.Step, tumble.World, tumble.Recorder):
        for name, member in vars(kind).items():
            if not name.startswith("_"):
                assert inspect.getdoc(member), f"{kind.__name__}.{name} has no docstring"
